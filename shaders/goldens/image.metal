// language: metal2.0
#include <metal_stdlib>
#include <simd/simd.h>

using metal::uint;

struct _mslBufferSizes {
    uint size1;
    uint size2;
    uint size3;
    uint size5;
    uint size6;
    uint size7;
};

typedef float real;
struct Ray {
    metal::float3 origin;
    metal::float3 direction;
};
struct Root {
    bool some;
    char _pad1[3];
    real lambda;
};
struct Hit {
    metal::float3 point;
    metal::packed_float3 normal;
    bool front;
    char _pad3[3];
};
struct SphereRecord {
    metal::packed_float3 center;
    real radius;
    real radius_squared;
    char _pad3[12];
};
struct SphereView {
    metal::packed_float3 r_c;
    real c;
};
struct SphereQuadratic {
    real h;
    real discriminant;
};
struct CylinderRecord {
    metal::float3 center;
    metal::float3 axis;
    metal::float3 top;
    metal::packed_float3 bottom;
    real radius;
    real radius_squared;
    real half_height;
    char _pad7[8];
};
struct CylinderView {
    metal::packed_float3 r_c;
    real c;
};
struct CylinderQuadratic {
    real a;
    real h;
    real discriminant;
};
struct CylinderRoot {
    bool some;
    char _pad1[3];
    real lambda;
    uint part;
};
struct Camera {
    metal::float3 position;
    metal::float3 origin;
    metal::float3 delta_x;
    metal::float3 delta_y;
};
struct Background {
    metal::float3 dark;
    metal::float3 light;
};
struct Material {
    metal::packed_float3 reflectance;
    real index;
    real extent;
    uint kind;
    char _pad4[8];
};
struct PackedVec3_ {
    real x;
    real y;
    real z;
};
struct PackedRay {
    PackedVec3_ origin;
    PackedVec3_ direction;
};
struct PlacedSphere {
    PackedVec3_ center;
    real radius;
    uint order;
    uint material;
};
struct PlacedCylinder {
    PackedVec3_ center;
    PackedVec3_ axis;
    real radius;
    real half_height;
    uint order;
    uint material;
};
struct PackedMaterial {
    PackedVec3_ reflectance;
    real index;
    real extent;
    uint kind;
    uint unused;
};
struct PackedCamera {
    PackedVec3_ position;
    PackedVec3_ origin;
    PackedVec3_ delta_x;
    PackedVec3_ delta_y;
};
struct PackedBackground {
    PackedVec3_ dark;
    PackedVec3_ light;
};
struct Picture {
    PackedCamera camera;
    PackedBackground background;
    real offset_x;
    real offset_y;
    PackedVec3_ scatter_vector;
    uint width;
    uint first_pixel;
    uint pixel_count;
    uint sphere_count;
    uint cylinder_count;
    uint first_depth;
    uint end_depth;
    uint sample_count;
    uint first_sample;
    uint samples_per_pixel;
    uint convention;
    uint unused;
};
typedef PlacedSphere type_5[1];
typedef PlacedCylinder type_6[1];
typedef PackedMaterial type_7[1];
struct ClosestHit {
    bool some;
    char _pad1[3];
    real lambda;
    uint order;
    bool is_cylinder;
    char _pad4[3];
    uint index;
    uint part;
};
struct SurfaceHit {
    bool some;
    char _pad1[15];
    Hit hit;
    uint material;
    real lambda;
    uint order;
    uint part;
};
typedef uint type_8[1];
struct PackedPath {
    PackedRay ray;
    uint attenuation_count;
    uint ended;
};
typedef PackedVec3_ type_9[1];
typedef PackedPath type_10[1];
constant real SHORT_SQUARED = 0.0;
constant real SHORT_SCALE = 1.0;
constant real BELOW_ONE = 0.99999994;
constant real LEAST_SQUARED = 0.0;
constant real ERROR_UNDERFLOW = 0.0;
constant real ERROR_OVERFLOW = 300000000000000000000000000000000000000.0;
constant real SHORTEST_SQUARED = 0.0;
constant real LONGEST_SQUARED = 300000000000000000000000000000000000000.0;
constant real EXTENT_UNDERFLOW = 0.0;
constant real SPLITTER = 4097.0;
constant real SPLIT_LIMIT = 1000000000000000000000000000000000.0;
constant real SPLIT_SCALE = 0.000015258789;
constant real SPLIT_UNSCALE = 65536.0;
constant real UNWRITTEN = -0.00000000000000028735182;
constant uint SIDE = 0u;
constant uint TOP = 1u;
constant uint BOTTOM = 2u;
constant uint MATTE = 0u;
constant uint METAL = 1u;
constant uint REFRACTIVE = 2u;
constant bool has_spheres = true;
constant bool has_cylinders = true;
constant bool has_matte = true;
constant bool has_metal = true;
constant bool has_refraction = true;
constant uint max_depth = 5u;

real vec3_dot(
    metal::float3 a,
    metal::float3 b
) {
    return ((a.x * b.x) + (a.y * b.y)) + (a.z * b.z);
}

real vec3_length(
    metal::float3 v
) {
    real _e1 = vec3_dot(v, v);
    return metal::sqrt(_e1);
}

metal::float3 vec3_unit(
    metal::float3 v_1
) {
    real _e1 = vec3_length(v_1);
    return v_1 / metal::float3(_e1);
}

metal::float3 vec3_perpendicular_to(
    metal::float3 v_2,
    metal::float3 axis
) {
    real _e2 = vec3_dot(v_2, axis);
    return v_2 - (axis * _e2);
}

bool vec3_is_negligible(
    metal::float3 v_3
) {
    return ((metal::abs(v_3.x) < 0.00000001) & (metal::abs(v_3.y) < 0.00000001)) & (metal::abs(v_3.z) < 0.00000001);
}

metal::float3 ray_at(
    Ray ray,
    real lambda
) {
    return ray.origin + (ray.direction * lambda);
}

bool in_range(
    real lambda_1
) {
    return 0.001 <= lambda_1;
}

Hit hit_facing(
    metal::float3 direction,
    metal::float3 point,
    metal::float3 outward
) {
    real _e3 = vec3_dot(direction, outward);
    bool front_1 = _e3 < 0.0;
    return Hit {point, front_1 ? outward : -(outward), front_1};
}

SphereRecord sphere_new(
    metal::float3 center,
    real radius
) {
    return SphereRecord {center, radius, radius * radius};
}

SphereView sphere_seen_from(
    SphereRecord sphere,
    metal::float3 origin
) {
    metal::float3 r_c = sphere.center - origin;
    real _e4 = vec3_dot(r_c, r_c);
    return SphereView {r_c, _e4 - sphere.radius_squared};
}

SphereQuadratic sphere_quadratic(
    SphereView view,
    metal::float3 direction_1,
    real a_1
) {
    real _e4 = vec3_dot(direction_1, view.r_c);
    return SphereQuadratic {_e4, (_e4 * _e4) - (a_1 * view.c)};
}

Root sphere_first_root(
    real a_2,
    real h,
    real discriminant
) {
    float root = metal::sqrt(discriminant);
    real near = (h - root) / a_2;
    real far = (h + root) / a_2;
    bool _e8 = in_range(near);
    real lambda_6 = _e8 ? near : far;
    bool _e10 = in_range(lambda_6);
    return Root {_e10, {}, lambda_6};
}

metal::float3 sphere_outward(
    SphereRecord sphere_1,
    metal::float3 point_1
) {
    return (point_1 - sphere_1.center) / metal::float3(sphere_1.radius);
}

Root sphere_intersect(
    SphereRecord sphere_2,
    Ray ray_1
) {
    real _e4 = vec3_dot(ray_1.direction, ray_1.direction);
    SphereView _e6 = sphere_seen_from(sphere_2, ray_1.origin);
    SphereQuadratic _e8 = sphere_quadratic(_e6, ray_1.direction, _e4);
    Root _e11 = sphere_first_root(_e4, _e8.h, _e8.discriminant);
    return Root {!((_e8.discriminant < 0.0)) & _e11.some, {}, _e11.lambda};
}

bool tie_later_cap_is_closer(
    real lambda_2,
    real closest
) {
    return lambda_2 < closest;
}

int tie_rank(
    uint order,
    bool on_cap
) {
    return on_cap ? as_type<int>(as_type<uint>(-1) - as_type<uint>(static_cast<int>(order))) : static_cast<int>(order);
}

bool tie_is_closer(
    real lambda_3,
    int rank,
    real closest_1,
    int closest_rank
) {
    return (lambda_3 < closest_1) | ((lambda_3 <= closest_1) & (rank >= closest_rank));
}

CylinderRecord cylinder_with_unit_axis(
    metal::float3 center_1,
    real radius_1,
    metal::float3 axis_1,
    real half_height
) {
    metal::float3 to_cap = axis_1 * half_height;
    return CylinderRecord {center_1, axis_1, center_1 + to_cap, center_1 - to_cap, radius_1, radius_1 * radius_1, half_height};
}

CylinderView cylinder_seen_from(
    CylinderRecord cylinder,
    metal::float3 origin_1
) {
    metal::float3 _e5 = vec3_perpendicular_to(origin_1 - cylinder.center, cylinder.axis);
    real _e6 = vec3_dot(_e5, _e5);
    return CylinderView {_e5, _e6 - cylinder.radius_squared};
}

CylinderQuadratic cylinder_quadratic(
    CylinderRecord cylinder_1,
    CylinderView view_1,
    metal::float3 along
) {
    metal::float3 _e4 = vec3_perpendicular_to(along, cylinder_1.axis);
    real _e5 = vec3_dot(_e4, _e4);
    real _e7 = vec3_dot(view_1.r_c, _e4);
    return CylinderQuadratic {_e5, _e7, (_e7 * _e7) - (_e5 * view_1.c)};
}

bool cylinder_within_height(
    CylinderRecord cylinder_2,
    Ray ray_2,
    real lambda_4
) {
    metal::float3 _e3 = ray_at(ray_2, lambda_4);
    real _e7 = vec3_dot(_e3 - cylinder_2.center, cylinder_2.axis);
    return metal::abs(_e7) <= cylinder_2.half_height;
}

Root cylinder_side(
    CylinderRecord cylinder_3,
    Ray ray_3,
    CylinderQuadratic quadratic
) {
    float root_1 = metal::sqrt(quadratic.discriminant);
    real near_1 = (-(quadratic.h) - root_1) / quadratic.a;
    real far_1 = (-(quadratic.h) + root_1) / quadratic.a;
    bool _e15 = in_range(near_1);
    bool _e16 = cylinder_within_height(cylinder_3, ray_3, near_1);
    bool near_counts = _e15 & _e16;
    bool _e18 = in_range(far_1);
    bool _e19 = cylinder_within_height(cylinder_3, ray_3, far_1);
    bool far_counts = _e18 & _e19;
    return Root {near_counts | far_counts, {}, near_counts ? near_1 : far_1};
}

Root cylinder_cap(
    CylinderRecord cylinder_4,
    Ray ray_4,
    metal::float3 center_2
) {
    real _e5 = vec3_dot(ray_4.direction, cylinder_4.axis);
    real _e9 = vec3_dot(center_2 - ray_4.origin, cylinder_4.axis);
    real lambda_7 = _e9 / _e5;
    metal::float3 _e11 = ray_at(ray_4, lambda_7);
    real _e13 = vec3_length(_e11 - center_2);
    bool on_disc = _e13 <= cylinder_4.radius;
    bool _e20 = in_range(lambda_7);
    return Root {(!((metal::abs(_e5) < 0.00000001)) & _e20) & on_disc, {}, lambda_7};
}

metal::float3 cylinder_outward(
    CylinderRecord cylinder_5,
    uint part,
    metal::float3 point_2
) {
    metal::float3 _e6 = vec3_perpendicular_to(point_2 - cylinder_5.center, cylinder_5.axis);
    metal::float3 cap = (part == TOP) ? cylinder_5.axis : -(cylinder_5.axis);
    return (part == SIDE) ? _e6 : cap;
}

CylinderRoot cylinder_closer(
    CylinderRoot closest_2,
    Root later,
    uint part_1
) {
    bool _e8 = tie_later_cap_is_closer(later.lambda, closest_2.lambda);
    bool replaces = later.some & (!(closest_2.some) | _e8);
    real lambda_8 = replaces ? later.lambda : closest_2.lambda;
    return CylinderRoot {closest_2.some | later.some, {}, lambda_8, replaces ? part_1 : closest_2.part};
}

CylinderRoot cylinder_with_caps(
    CylinderRecord cylinder_6,
    Ray ray_5,
    Root side
) {
    Root _e4 = cylinder_cap(cylinder_6, ray_5, cylinder_6.top);
    Root _e6 = cylinder_cap(cylinder_6, ray_5, cylinder_6.bottom);
    CylinderRoot _e12 = cylinder_closer(CylinderRoot {side.some, {}, side.lambda, SIDE}, _e4, TOP);
    CylinderRoot _e14 = cylinder_closer(_e12, _e6, BOTTOM);
    return _e14;
}

CylinderRoot cylinder_intersect(
    CylinderRecord cylinder_7,
    Ray ray_6
) {
    CylinderView _e3 = cylinder_seen_from(cylinder_7, ray_6.origin);
    CylinderQuadratic _e5 = cylinder_quadratic(cylinder_7, _e3, ray_6.direction);
    Root _e6 = cylinder_side(cylinder_7, ray_6, _e5);
    bool some = !((_e5.discriminant < 0.0)) & _e6.some;
    CylinderRoot _e15 = cylinder_with_caps(cylinder_7, ray_6, Root {some, {}, _e6.lambda});
    return _e15;
}

Ray camera_ray(
    Camera camera,
    real row,
    real column,
    metal::float2 offset
) {
    float x = offset.x;
    float y = offset.y;
    metal::float3 window_point = (camera.origin + (camera.delta_x * (column + x))) + (camera.delta_y * (row + y));
    return Ray {camera.position, window_point - camera.position};
}

metal::float3 background_color(
    Background background,
    metal::float3 direction_2
) {
    real _e3 = vec3_length(direction_2);
    float m = ((direction_2.y / _e3) + 1.0) / 2.0;
    return (background.light * (1.0 - m)) + (background.dark * m);
}

metal::float3 scatter_matte(
    metal::float3 normal,
    metal::float3 vector
) {
    metal::float3 direction_8 = normal + vector;
    bool _e3 = vec3_is_negligible(direction_8);
    return _e3 ? normal : direction_8;
}

metal::float3 scatter_reflect(
    metal::float3 direction_3,
    metal::float3 normal_1
) {
    real _e2 = vec3_dot(direction_3, normal_1);
    return direction_3 - (normal_1 * (_e2 * 2.0));
}

metal::float3 scatter_mirror(
    metal::float3 direction_4,
    metal::float3 normal_2
) {
    metal::float3 _e2 = scatter_reflect(direction_4, normal_2);
    metal::float3 _e3 = vec3_unit(_e2);
    return _e3;
}

metal::float3 scatter_metal(
    metal::float3 direction_5,
    metal::float3 normal_3,
    metal::float3 vector_1
) {
    metal::float3 _e3 = scatter_mirror(direction_5, normal_3);
    return _e3 + vector_1;
}

real scatter_index_ratio(
    real index,
    bool front
) {
    return front ? (1.0 / index) : index;
}

metal::float3 scatter_refract(
    metal::float3 direction_6,
    metal::float3 normal_4,
    real ratio
) {
    metal::float3 _e4 = vec3_unit(direction_6);
    real _e5 = vec3_dot(_e4, normal_4);
    real product = -(_e5);
    real cos = (product < 1.0) ? product : 1.0;
    float sin = metal::sqrt(1.0 - (cos * cos));
    metal::float3 _e12 = scatter_reflect(_e4, normal_4);
    metal::float3 p = (_e4 + (normal_4 * cos)) * ratio;
    real _e16 = vec3_dot(p, p);
    metal::float3 refracted = p - (normal_4 * metal::sqrt(metal::abs(1.0 - _e16)));
    bool beyond = 1.0 < (ratio * sin);
    return beyond ? _e12 : refracted;
}

metal::float3 vec3_load(
    PackedVec3_ v_4
) {
    return metal::float3(v_4.x, v_4.y, v_4.z);
}

PackedVec3_ vec3_store(
    metal::float3 v_5
) {
    return PackedVec3_ {v_5.x, v_5.y, v_5.z};
}

Ray ray_load(
    PackedRay ray_7
) {
    metal::float3 _e2 = vec3_load(ray_7.origin);
    metal::float3 _e4 = vec3_load(ray_7.direction);
    return Ray {_e2, _e4};
}

PackedRay ray_store(
    Ray ray_8
) {
    PackedVec3_ _e2 = vec3_store(ray_8.origin);
    PackedVec3_ _e4 = vec3_store(ray_8.direction);
    return PackedRay {_e2, _e4};
}

SphereRecord sphere_load(
    PlacedSphere sphere_3
) {
    metal::float3 _e2 = vec3_load(sphere_3.center);
    SphereRecord _e4 = sphere_new(_e2, sphere_3.radius);
    return _e4;
}

CylinderRecord cylinder_load(
    PlacedCylinder cylinder_8
) {
    metal::float3 _e2 = vec3_load(cylinder_8.axis);
    metal::float3 _e4 = vec3_load(cylinder_8.center);
    CylinderRecord _e7 = cylinder_with_unit_axis(_e4, cylinder_8.radius, _e2, cylinder_8.half_height);
    return _e7;
}

Material material_load(
    PackedMaterial material
) {
    metal::float3 _e2 = vec3_load(material.reflectance);
    return Material {_e2, material.index, material.extent, material.kind};
}

Camera picture_camera(
    device Picture const& picture
) {
    PackedVec3_ _e3 = picture.camera.position;
    metal::float3 _e4 = vec3_load(_e3);
    PackedVec3_ _e8 = picture.camera.origin;
    metal::float3 _e9 = vec3_load(_e8);
    PackedVec3_ _e13 = picture.camera.delta_x;
    metal::float3 _e14 = vec3_load(_e13);
    PackedVec3_ _e18 = picture.camera.delta_y;
    metal::float3 _e19 = vec3_load(_e18);
    return Camera {_e4, _e9, _e14, _e19};
}

Background picture_background(
    device Picture const& picture
) {
    PackedVec3_ _e3 = picture.background.dark;
    metal::float3 _e4 = vec3_load(_e3);
    PackedVec3_ _e8 = picture.background.light;
    metal::float3 _e9 = vec3_load(_e8);
    return Background {_e4, _e9};
}

bool is_closer(
    ClosestHit closest_3,
    real lambda_5,
    uint order_1,
    uint part_2
) {
    int _e8 = tie_rank(closest_3.order, closest_3.part != SIDE);
    int _e11 = tie_rank(order_1, part_2 != SIDE);
    bool _e15 = tie_is_closer(lambda_5, _e11, closest_3.lambda, _e8);
    return !(closest_3.some) | _e15;
}

ClosestHit intersect_sphere(
    ClosestHit closest_4,
    Ray ray_9,
    uint index_1,
    device type_5 const& spheres,
    constant _mslBufferSizes& _buffer_sizes
) {
    ClosestHit result = {};
    PlacedSphere placed = spheres[index_1];
    SphereRecord _e6 = sphere_load(placed);
    Root _e7 = sphere_intersect(_e6, ray_9);
    uint order_2 = placed.order;
    result = closest_4;
    bool _e13 = is_closer(closest_4, _e7.lambda, order_2, SIDE);
    if (_e7.some & _e13) {
        result = ClosestHit {true, {}, _e7.lambda, order_2, false, {}, index_1, SIDE};
    }
    ClosestHit _e20 = result;
    return _e20;
}

ClosestHit intersect_cylinder(
    ClosestHit closest_5,
    Ray ray_10,
    uint index_2,
    device type_6 const& cylinders,
    constant _mslBufferSizes& _buffer_sizes
) {
    ClosestHit result_1 = {};
    PlacedCylinder placed_1 = cylinders[index_2];
    CylinderRecord _e6 = cylinder_load(placed_1);
    CylinderRoot _e7 = cylinder_intersect(_e6, ray_10);
    uint order_3 = placed_1.order;
    result_1 = closest_5;
    bool _e13 = is_closer(closest_5, _e7.lambda, order_3, _e7.part);
    if (_e7.some & _e13) {
        result_1 = ClosestHit {true, {}, _e7.lambda, order_3, true, {}, index_2, _e7.part};
    }
    ClosestHit _e20 = result_1;
    return _e20;
}

SurfaceHit surface_at(
    ClosestHit closest_6,
    Ray ray_11,
    device type_5 const& spheres,
    device type_6 const& cylinders,
    constant _mslBufferSizes& _buffer_sizes
) {
    metal::float3 outward_1 = {};
    uint material_1 = {};
    bool local = {};
    bool local_1 = {};
    metal::float3 _e3 = ray_at(ray_11, closest_6.lambda);
    if (has_spheres) {
        local = !(closest_6.is_cylinder);
    } else {
        local = false;
    }
    bool _e12 = local;
    if (_e12) {
        PlacedSphere _e16 = spheres[closest_6.index];
        SphereRecord _e17 = sphere_load(_e16);
        metal::float3 _e18 = sphere_outward(_e17, _e3);
        outward_1 = _e18;
        uint _e23 = spheres[closest_6.index].material;
        material_1 = _e23;
    }
    if (has_cylinders) {
        local_1 = closest_6.is_cylinder;
    } else {
        local_1 = false;
    }
    bool _e29 = local_1;
    if (_e29) {
        PlacedCylinder _e33 = cylinders[closest_6.index];
        CylinderRecord _e34 = cylinder_load(_e33);
        metal::float3 _e36 = cylinder_outward(_e34, closest_6.part, _e3);
        outward_1 = _e36;
        uint _e41 = cylinders[closest_6.index].material;
        material_1 = _e41;
    }
    metal::float3 _e43 = outward_1;
    Hit _e44 = hit_facing(ray_11.direction, _e3, _e43);
    uint _e46 = material_1;
    return SurfaceHit {closest_6.some, {}, _e44, _e46, closest_6.lambda, closest_6.order, closest_6.part};
}

ClosestHit intersect_every_object(
    Ray ray_12,
    device Picture const& picture,
    device type_5 const& spheres,
    device type_6 const& cylinders,
    constant _mslBufferSizes& _buffer_sizes
) {
    ClosestHit closest_7 = {};
    uint index_3 = 0u;
    uint index_4 = 0u;
    if (has_spheres) {
        uint2 loop_bound = uint2(4294967295u);
        bool loop_init = true;
        while(true) {
            if (metal::all(loop_bound == uint2(0u))) { break; }
            loop_bound -= uint2(loop_bound.y == 0u, 1u);
            if (!loop_init) {
                uint _e14 = index_3;
                index_3 = _e14 + 1u;
            }
            loop_init = false;
            uint _e5 = index_3;
            uint _e8 = picture.sphere_count;
            if (_e5 < _e8) {
            } else {
                break;
            }
            {
                ClosestHit _e10 = closest_7;
                uint _e11 = index_3;
                ClosestHit _e12 = intersect_sphere(_e10, ray_12, _e11, spheres, _buffer_sizes);
                closest_7 = _e12;
            }
        }
    }
    if (has_cylinders) {
        uint2 loop_bound_1 = uint2(4294967295u);
        bool loop_init_1 = true;
        while(true) {
            if (metal::all(loop_bound_1 == uint2(0u))) { break; }
            loop_bound_1 -= uint2(loop_bound_1.y == 0u, 1u);
            if (!loop_init_1) {
                uint _e28 = index_4;
                index_4 = _e28 + 1u;
            }
            loop_init_1 = false;
            uint _e19 = index_4;
            uint _e22 = picture.cylinder_count;
            if (_e19 < _e22) {
            } else {
                break;
            }
            {
                ClosestHit _e24 = closest_7;
                uint _e25 = index_4;
                ClosestHit _e26 = intersect_cylinder(_e24, ray_12, _e25, cylinders, _buffer_sizes);
                closest_7 = _e26;
            }
        }
    }
    ClosestHit _e30 = closest_7;
    return _e30;
}

SurfaceHit closest_hit(
    Ray ray_13,
    device Picture const& picture,
    device type_5 const& spheres,
    device type_6 const& cylinders,
    constant _mslBufferSizes& _buffer_sizes
) {
    ClosestHit _e1 = intersect_every_object(ray_13, picture, spheres, cylinders, _buffer_sizes);
    SurfaceHit _e2 = surface_at(_e1, ray_13, spheres, cylinders, _buffer_sizes);
    return _e2;
}

bool bounce_attenuates(
    Material material_2
) {
    bool local_2 = {};
    bool local_3 = {};
    bool local_4 = {};
    if (has_matte) {
        local_2 = material_2.kind == MATTE;
    } else {
        local_2 = false;
    }
    bool _e8 = local_2;
    if (!(_e8)) {
        if (has_metal) {
            local_4 = material_2.kind == METAL;
        } else {
            local_4 = false;
        }
        bool _e19 = local_4;
        local_3 = _e19;
    } else {
        local_3 = true;
    }
    bool _e21 = local_3;
    return _e21;
}

Ray bounce_ray(
    Ray ray_14,
    Hit hit,
    Material material_3,
    metal::float3 scatter_vector
) {
    metal::float3 direction_7 = {};
    bool local_5 = {};
    bool local_6 = {};
    bool local_7 = {};
    if (has_matte) {
        local_5 = material_3.kind == MATTE;
    } else {
        local_5 = false;
    }
    bool _e12 = local_5;
    if (_e12) {
        metal::float3 _e14 = scatter_matte(hit.normal, scatter_vector);
        direction_7 = _e14;
    }
    if (has_metal) {
        local_6 = material_3.kind == METAL;
    } else {
        local_6 = false;
    }
    bool _e22 = local_6;
    if (_e22) {
        metal::float3 _e25 = scatter_metal(ray_14.direction, hit.normal, scatter_vector);
        direction_7 = _e25;
    }
    if (has_refraction) {
        local_7 = material_3.kind == REFRACTIVE;
    } else {
        local_7 = false;
    }
    bool _e33 = local_7;
    if (_e33) {
        real _e36 = scatter_index_ratio(material_3.index, hit.front);
        metal::float3 _e39 = scatter_refract(ray_14.direction, hit.normal, _e36);
        direction_7 = _e39;
    }
    metal::float3 _e41 = direction_7;
    return Ray {hit.point, _e41};
}

metal::float3 bounce_attenuated(
    metal::float3 color,
    uint first,
    uint attenuation_count,
    device type_7 const& materials,
    device type_8 const& attenuations,
    constant _mslBufferSizes& _buffer_sizes
) {
    metal::float3 attenuated = {};
    uint left = {};
    attenuated = color;
    left = attenuation_count;
    uint2 loop_bound_2 = uint2(4294967295u);
    bool loop_init_2 = true;
    while(true) {
        if (metal::all(loop_bound_2 == uint2(0u))) { break; }
        loop_bound_2 -= uint2(loop_bound_2.y == 0u, 1u);
        if (!loop_init_2) {
            uint _e23 = left;
            left = _e23 - 1u;
        }
        loop_init_2 = false;
        uint _e5 = left;
        if (_e5 > 0u) {
        } else {
            break;
        }
        {
            metal::float3 _e8 = attenuated;
            uint _e11 = left;
            uint _e16 = attenuations[(first + _e11) - 1u];
            PackedVec3_ _e19 = materials[_e16].reflectance;
            metal::float3 _e20 = vec3_load(_e19);
            attenuated = _e8 * _e20;
        }
    }
    metal::float3 _e25 = attenuated;
    return _e25;
}

void trace_path(
    Ray primary,
    uint slot,
    device Picture const& picture,
    device type_5 const& spheres,
    device type_6 const& cylinders,
    device type_7 const& materials,
    device type_8& attenuations,
    device type_9& pixels,
    device type_10& paths,
    constant _mslBufferSizes& _buffer_sizes
) {
    Ray ray_15 = {};
    uint attenuation_count_1 = 0u;
    bool escapes = false;
    uint depth = {};
    metal::float3 color_1 = metal::float3 {};
    ray_15 = primary;
    PackedVec3_ _e5 = picture.scatter_vector;
    metal::float3 _e6 = vec3_load(_e5);
    uint first_1 = slot * max_depth;
    uint _e15 = picture.first_depth;
    if (_e15 > 0u) {
        uint _e21 = paths[slot].ended;
        if (_e21 != 0u) {
            return;
        }
        PackedRay _e27 = paths[slot].ray;
        Ray _e28 = ray_load(_e27);
        ray_15 = _e28;
        uint _e32 = paths[slot].attenuation_count;
        attenuation_count_1 = _e32;
    }
    uint _e35 = picture.first_depth;
    depth = _e35;
    uint2 loop_bound_3 = uint2(4294967295u);
    bool loop_init_3 = true;
    while(true) {
        if (metal::all(loop_bound_3 == uint2(0u))) { break; }
        loop_bound_3 -= uint2(loop_bound_3.y == 0u, 1u);
        if (!loop_init_3) {
            uint _e67 = depth;
            depth = _e67 + 1u;
        }
        loop_init_3 = false;
        uint _e37 = depth;
        uint _e41 = picture.end_depth;
        if (_e37 < metal::min(max_depth, _e41)) {
        } else {
            break;
        }
        {
            Ray _e44 = ray_15;
            SurfaceHit _e45 = closest_hit(_e44, picture, spheres, cylinders, _buffer_sizes);
            if (!(_e45.some)) {
                escapes = true;
                break;
            }
            PackedMaterial _e52 = materials[_e45.material];
            Material _e53 = material_load(_e52);
            bool _e54 = bounce_attenuates(_e53);
            if (_e54) {
                uint _e56 = attenuation_count_1;
                attenuations[first_1 + _e56] = _e45.material;
                uint _e61 = attenuation_count_1;
                attenuation_count_1 = _e61 + 1u;
            }
            Ray _e63 = ray_15;
            Ray _e65 = bounce_ray(_e63, _e45.hit, _e53, _e6);
            ray_15 = _e65;
        }
    }
    bool _e71 = escapes;
    if (_e71) {
        Background _e72 = picture_background(picture);
        metal::float3 _e74 = ray_15.direction;
        metal::float3 _e75 = background_color(_e72, _e74);
        uint _e76 = attenuation_count_1;
        metal::float3 _e77 = bounce_attenuated(_e75, first_1, _e76, materials, attenuations, _buffer_sizes);
        color_1 = _e77;
    }
    metal::float3 _e80 = color_1;
    PackedVec3_ _e81 = vec3_store(_e80);
    pixels[slot] = _e81;
    Ray _e84 = ray_15;
    PackedRay _e85 = ray_store(_e84);
    uint _e86 = attenuation_count_1;
    bool _e89 = escapes;
    paths[slot] = PackedPath {_e85, _e86, _e89 ? 1u : 0u};
    return;
}
uint naga_div(uint lhs, uint rhs) {
    return lhs / metal::select(rhs, 1u, rhs == 0u);
}

uint naga_mod(uint lhs, uint rhs) {
    return lhs % metal::select(rhs, 1u, rhs == 0u);
}


struct imageInput {
};
kernel void image(
  metal::uint3 id [[thread_position_in_grid]]
, device Picture const& picture [[buffer(0)]]
, device type_5 const& spheres [[buffer(1)]]
, device type_6 const& cylinders [[buffer(2)]]
, device type_7 const& materials [[buffer(3)]]
, device type_8& attenuations [[buffer(4)]]
, device type_9& pixels [[buffer(5)]]
, device type_10& paths [[buffer(6)]]
, constant _mslBufferSizes& _buffer_sizes [[buffer(7)]]
) {
    bool closest_hit_gave_up = {};
    uint _e4 = picture.pixel_count;
    if (id.x >= _e4) {
        return;
    }
    uint _e8 = picture.first_pixel;
    uint pixel = _e8 + id.x;
    uint _e13 = picture.width;
    float row_1 = static_cast<float>(naga_div(pixel, _e13));
    uint _e18 = picture.width;
    float column_1 = static_cast<float>(naga_mod(pixel, _e18));
    real _e23 = picture.offset_x;
    real _e26 = picture.offset_y;
    metal::float2 offset_1 = metal::float2(_e23, _e26);
    Camera _e28 = picture_camera(picture);
    Ray _e29 = camera_ray(_e28, row_1, column_1, offset_1);
    trace_path(_e29, id.x, picture, spheres, cylinders, materials, attenuations, pixels, paths, _buffer_sizes);
    bool _e32 = closest_hit_gave_up;
    if (_e32) {
        PackedVec3_ _e38 = vec3_store(metal::float3(-0.00000000000000028735182));
        pixels[id.x] = _e38;
        paths[id.x].ended = 1u;
        return;
    } else {
        return;
    }
}

#version 310 es

precision highp float;
precision highp int;

layout(local_size_x = 64, local_size_y = 1, local_size_z = 1) in;

struct Ray {
    vec3 origin;
    vec3 direction;
};
struct Root {
    bool some;
    float lambda;
};
struct Hit {
    vec3 point;
    vec3 normal;
    bool front;
};
struct SphereRecord {
    vec3 center;
    float radius;
    float radius_squared;
};
struct SphereView {
    vec3 r_c;
    float c;
};
struct SphereQuadratic {
    float h;
    float discriminant;
};
struct CylinderRecord {
    vec3 center;
    vec3 axis;
    vec3 top;
    vec3 bottom;
    float radius;
    float radius_squared;
    float half_height;
};
struct CylinderView {
    vec3 r_c;
    float c;
};
struct CylinderQuadratic {
    float a;
    float h;
    float discriminant;
};
struct CylinderRoot {
    bool some;
    float lambda;
    uint part;
};
struct Camera {
    vec3 position;
    vec3 origin;
    vec3 delta_x;
    vec3 delta_y;
};
struct Background {
    vec3 dark;
    vec3 light;
};
struct Material {
    vec3 reflectance;
    float index;
    float extent;
    uint kind;
};
struct PackedVec3_ {
    float x;
    float y;
    float z;
};
struct PackedRay {
    PackedVec3_ origin;
    PackedVec3_ direction;
};
struct PlacedSphere {
    PackedVec3_ center;
    float radius;
    uint order;
    uint material;
};
struct PlacedCylinder {
    PackedVec3_ center;
    PackedVec3_ axis;
    float radius;
    float half_height;
    uint order;
    uint material;
};
struct PackedMaterial {
    PackedVec3_ reflectance;
    float index;
    float extent;
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
    float offset_x;
    float offset_y;
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
struct ClosestHit {
    bool some;
    float lambda;
    uint order;
    bool is_cylinder;
    uint index;
    uint part;
};
struct SurfaceHit {
    bool some;
    Hit hit;
    uint material;
    float lambda;
    uint order;
    uint part;
};
struct PackedPath {
    PackedRay ray;
    uint attenuation_count;
    uint ended;
};
const float SHORT_SQUARED = 0.0;
const float SHORT_SCALE = 1.0;
const float BELOW_ONE = 0.99999994;
const float LEAST_SQUARED = 0.0;
const float ERROR_UNDERFLOW = 0.0;
const float ERROR_OVERFLOW = 3e38;
const float SHORTEST_SQUARED = 0.0;
const float LONGEST_SQUARED = 3e38;
const float EXTENT_UNDERFLOW = 0.0;
const float SPLITTER = 4097.0;
const float SPLIT_LIMIT = 1e33;
const float SPLIT_SCALE = 1.5258789e-5;
const float SPLIT_UNSCALE = 65536.0;
const float UNWRITTEN = -2.8735182e-16;
const uint SIDE = 0u;
const uint TOP = 1u;
const uint BOTTOM = 2u;
const uint MATTE = 0u;
const uint METAL = 1u;
const uint REFRACTIVE = 2u;
const bool has_spheres = true;
const bool has_cylinders = true;
const bool has_matte = true;
const bool has_metal = true;
const bool has_refraction = true;
const uint max_depth = 5u;

layout(std430, binding = 0) readonly buffer Picture_block_0Compute { Picture _group_0_binding_0_cs; };

layout(std430, binding = 1) readonly buffer type_5_block_1Compute { PlacedSphere _group_0_binding_1_cs[]; };

layout(std430, binding = 2) readonly buffer type_6_block_2Compute { PlacedCylinder _group_0_binding_2_cs[]; };

layout(std430, binding = 3) readonly buffer type_7_block_3Compute { PackedMaterial _group_0_binding_3_cs[]; };

bool closest_hit_gave_up = false;

layout(std430, binding = 4) buffer type_8_block_4Compute { uint _group_0_binding_4_cs[]; };

layout(std430, binding = 5) buffer type_9_block_5Compute { PackedVec3_ _group_0_binding_5_cs[]; };

layout(std430, binding = 6) buffer type_10_block_6Compute { PackedPath _group_0_binding_6_cs[]; };


float vec3_dot(vec3 a, vec3 b) {
    return (((a.x * b.x) + (a.y * b.y)) + (a.z * b.z));
}

float vec3_length(vec3 v) {
    float _e1 = vec3_dot(v, v);
    return sqrt(_e1);
}

vec3 vec3_unit(vec3 v_1) {
    float _e1 = vec3_length(v_1);
    return (v_1 / vec3(_e1));
}

vec3 vec3_perpendicular_to(vec3 v_2, vec3 axis) {
    float _e2 = vec3_dot(v_2, axis);
    return (v_2 - (axis * _e2));
}

bool vec3_is_negligible(vec3 v_3) {
    return (((abs(v_3.x) < 1e-8) && (abs(v_3.y) < 1e-8)) && (abs(v_3.z) < 1e-8));
}

vec3 ray_at(Ray ray, float lambda) {
    return (ray.origin + (ray.direction * lambda));
}

bool in_range(float lambda_1) {
    return (0.001 <= lambda_1);
}

Hit hit_facing(vec3 direction, vec3 point, vec3 outward) {
    float _e3 = vec3_dot(direction, outward);
    bool front_1 = (_e3 < 0.0);
    return Hit(point, (front_1 ? outward : -(outward)), front_1);
}

SphereRecord sphere_new(vec3 center, float radius) {
    return SphereRecord(center, radius, (radius * radius));
}

SphereView sphere_seen_from(SphereRecord sphere, vec3 origin) {
    vec3 r_c = (sphere.center - origin);
    float _e4 = vec3_dot(r_c, r_c);
    return SphereView(r_c, (_e4 - sphere.radius_squared));
}

SphereQuadratic sphere_quadratic(SphereView view, vec3 direction_1, float a_1) {
    float _e4 = vec3_dot(direction_1, view.r_c);
    return SphereQuadratic(_e4, ((_e4 * _e4) - (a_1 * view.c)));
}

Root sphere_first_root(float a_2, float h, float discriminant) {
    float root = sqrt(discriminant);
    float near = ((h - root) / a_2);
    float far = ((h + root) / a_2);
    bool _e8 = in_range(near);
    float lambda_6 = (_e8 ? near : far);
    bool _e10 = in_range(lambda_6);
    return Root(_e10, lambda_6);
}

vec3 sphere_outward(SphereRecord sphere_1, vec3 point_1) {
    return ((point_1 - sphere_1.center) / vec3(sphere_1.radius));
}

Root sphere_intersect(SphereRecord sphere_2, Ray ray_1) {
    float _e4 = vec3_dot(ray_1.direction, ray_1.direction);
    SphereView _e6 = sphere_seen_from(sphere_2, ray_1.origin);
    SphereQuadratic _e8 = sphere_quadratic(_e6, ray_1.direction, _e4);
    Root _e11 = sphere_first_root(_e4, _e8.h, _e8.discriminant);
    return Root((!((_e8.discriminant < 0.0)) && _e11.some), _e11.lambda);
}

bool tie_later_cap_is_closer(float lambda_2, float closest) {
    return (lambda_2 < closest);
}

int tie_rank(uint order, bool on_cap) {
    return (on_cap ? (-1 - int(order)) : int(order));
}

bool tie_is_closer(float lambda_3, int rank, float closest_1, int closest_rank) {
    return ((lambda_3 < closest_1) || ((lambda_3 <= closest_1) && (rank >= closest_rank)));
}

CylinderRecord cylinder_with_unit_axis(vec3 center_1, float radius_1, vec3 axis_1, float half_height) {
    vec3 to_cap = (axis_1 * half_height);
    return CylinderRecord(center_1, axis_1, (center_1 + to_cap), (center_1 - to_cap), radius_1, (radius_1 * radius_1), half_height);
}

CylinderView cylinder_seen_from(CylinderRecord cylinder, vec3 origin_1) {
    vec3 _e5 = vec3_perpendicular_to((origin_1 - cylinder.center), cylinder.axis);
    float _e6 = vec3_dot(_e5, _e5);
    return CylinderView(_e5, (_e6 - cylinder.radius_squared));
}

CylinderQuadratic cylinder_quadratic(CylinderRecord cylinder_1, CylinderView view_1, vec3 along) {
    vec3 _e4 = vec3_perpendicular_to(along, cylinder_1.axis);
    float _e5 = vec3_dot(_e4, _e4);
    float _e7 = vec3_dot(view_1.r_c, _e4);
    return CylinderQuadratic(_e5, _e7, ((_e7 * _e7) - (_e5 * view_1.c)));
}

bool cylinder_within_height(CylinderRecord cylinder_2, Ray ray_2, float lambda_4) {
    vec3 _e3 = ray_at(ray_2, lambda_4);
    float _e7 = vec3_dot((_e3 - cylinder_2.center), cylinder_2.axis);
    return (abs(_e7) <= cylinder_2.half_height);
}

Root cylinder_side(CylinderRecord cylinder_3, Ray ray_3, CylinderQuadratic quadratic) {
    float root_1 = sqrt(quadratic.discriminant);
    float near_1 = ((-(quadratic.h) - root_1) / quadratic.a);
    float far_1 = ((-(quadratic.h) + root_1) / quadratic.a);
    bool _e15 = in_range(near_1);
    bool _e16 = cylinder_within_height(cylinder_3, ray_3, near_1);
    bool near_counts = (_e15 && _e16);
    bool _e18 = in_range(far_1);
    bool _e19 = cylinder_within_height(cylinder_3, ray_3, far_1);
    bool far_counts = (_e18 && _e19);
    return Root((near_counts || far_counts), (near_counts ? near_1 : far_1));
}

Root cylinder_cap(CylinderRecord cylinder_4, Ray ray_4, vec3 center_2) {
    float _e5 = vec3_dot(ray_4.direction, cylinder_4.axis);
    float _e9 = vec3_dot((center_2 - ray_4.origin), cylinder_4.axis);
    float lambda_7 = (_e9 / _e5);
    vec3 _e11 = ray_at(ray_4, lambda_7);
    float _e13 = vec3_length((_e11 - center_2));
    bool on_disc = (_e13 <= cylinder_4.radius);
    bool _e20 = in_range(lambda_7);
    return Root(((!((abs(_e5) < 1e-8)) && _e20) && on_disc), lambda_7);
}

vec3 cylinder_outward(CylinderRecord cylinder_5, uint part, vec3 point_2) {
    vec3 _e6 = vec3_perpendicular_to((point_2 - cylinder_5.center), cylinder_5.axis);
    vec3 cap = ((part == TOP) ? cylinder_5.axis : -(cylinder_5.axis));
    return ((part == SIDE) ? _e6 : cap);
}

CylinderRoot cylinder_closer(CylinderRoot closest_2, Root later, uint part_1) {
    bool _e8 = tie_later_cap_is_closer(later.lambda, closest_2.lambda);
    bool replaces = (later.some && (!(closest_2.some) || _e8));
    float lambda_8 = (replaces ? later.lambda : closest_2.lambda);
    return CylinderRoot((closest_2.some || later.some), lambda_8, (replaces ? part_1 : closest_2.part));
}

CylinderRoot cylinder_with_caps(CylinderRecord cylinder_6, Ray ray_5, Root side) {
    Root _e4 = cylinder_cap(cylinder_6, ray_5, cylinder_6.top);
    Root _e6 = cylinder_cap(cylinder_6, ray_5, cylinder_6.bottom);
    CylinderRoot _e12 = cylinder_closer(CylinderRoot(side.some, side.lambda, SIDE), _e4, TOP);
    CylinderRoot _e14 = cylinder_closer(_e12, _e6, BOTTOM);
    return _e14;
}

CylinderRoot cylinder_intersect(CylinderRecord cylinder_7, Ray ray_6) {
    CylinderView _e3 = cylinder_seen_from(cylinder_7, ray_6.origin);
    CylinderQuadratic _e5 = cylinder_quadratic(cylinder_7, _e3, ray_6.direction);
    Root _e6 = cylinder_side(cylinder_7, ray_6, _e5);
    bool some = (!((_e5.discriminant < 0.0)) && _e6.some);
    CylinderRoot _e15 = cylinder_with_caps(cylinder_7, ray_6, Root(some, _e6.lambda));
    return _e15;
}

Ray camera_ray(Camera camera, float row, float column, vec2 offset) {
    float x = offset.x;
    float y = offset.y;
    vec3 window_point = ((camera.origin + (camera.delta_x * (column + x))) + (camera.delta_y * (row + y)));
    return Ray(camera.position, (window_point - camera.position));
}

vec3 background_color(Background background, vec3 direction_2) {
    float _e3 = vec3_length(direction_2);
    float m = (((direction_2.y / _e3) + 1.0) / 2.0);
    return ((background.light * (1.0 - m)) + (background.dark * m));
}

vec3 scatter_matte(vec3 normal, vec3 vector) {
    vec3 direction_8 = (normal + vector);
    bool _e3 = vec3_is_negligible(direction_8);
    return (_e3 ? normal : direction_8);
}

vec3 scatter_reflect(vec3 direction_3, vec3 normal_1) {
    float _e2 = vec3_dot(direction_3, normal_1);
    return (direction_3 - (normal_1 * (_e2 * 2.0)));
}

vec3 scatter_mirror(vec3 direction_4, vec3 normal_2) {
    vec3 _e2 = scatter_reflect(direction_4, normal_2);
    vec3 _e3 = vec3_unit(_e2);
    return _e3;
}

vec3 scatter_metal(vec3 direction_5, vec3 normal_3, vec3 vector_1) {
    vec3 _e3 = scatter_mirror(direction_5, normal_3);
    return (_e3 + vector_1);
}

float scatter_index_ratio(float index, bool front) {
    return (front ? (1.0 / index) : index);
}

vec3 scatter_refract(vec3 direction_6, vec3 normal_4, float ratio) {
    vec3 _e4 = vec3_unit(direction_6);
    float _e5 = vec3_dot(_e4, normal_4);
    float product = -(_e5);
    float cos_ = ((product < 1.0) ? product : 1.0);
    float sin_ = sqrt((1.0 - (cos_ * cos_)));
    vec3 _e12 = scatter_reflect(_e4, normal_4);
    vec3 p = ((_e4 + (normal_4 * cos_)) * ratio);
    float _e16 = vec3_dot(p, p);
    vec3 refracted = (p - (normal_4 * sqrt(abs((1.0 - _e16)))));
    bool beyond = (1.0 < (ratio * sin_));
    return (beyond ? _e12 : refracted);
}

vec3 vec3_load(PackedVec3_ v_4) {
    return vec3(v_4.x, v_4.y, v_4.z);
}

PackedVec3_ vec3_store(vec3 v_5) {
    return PackedVec3_(v_5.x, v_5.y, v_5.z);
}

Ray ray_load(PackedRay ray_7) {
    vec3 _e2 = vec3_load(ray_7.origin);
    vec3 _e4 = vec3_load(ray_7.direction);
    return Ray(_e2, _e4);
}

PackedRay ray_store(Ray ray_8) {
    PackedVec3_ _e2 = vec3_store(ray_8.origin);
    PackedVec3_ _e4 = vec3_store(ray_8.direction);
    return PackedRay(_e2, _e4);
}

SphereRecord sphere_load(PlacedSphere sphere_3) {
    vec3 _e2 = vec3_load(sphere_3.center);
    SphereRecord _e4 = sphere_new(_e2, sphere_3.radius);
    return _e4;
}

CylinderRecord cylinder_load(PlacedCylinder cylinder_8) {
    vec3 _e2 = vec3_load(cylinder_8.axis);
    vec3 _e4 = vec3_load(cylinder_8.center);
    CylinderRecord _e7 = cylinder_with_unit_axis(_e4, cylinder_8.radius, _e2, cylinder_8.half_height);
    return _e7;
}

Material material_load(PackedMaterial material) {
    vec3 _e2 = vec3_load(material.reflectance);
    return Material(_e2, material.index, material.extent, material.kind);
}

Camera picture_camera() {
    PackedVec3_ _e3 = _group_0_binding_0_cs.camera.position;
    vec3 _e4 = vec3_load(_e3);
    PackedVec3_ _e8 = _group_0_binding_0_cs.camera.origin;
    vec3 _e9 = vec3_load(_e8);
    PackedVec3_ _e13 = _group_0_binding_0_cs.camera.delta_x;
    vec3 _e14 = vec3_load(_e13);
    PackedVec3_ _e18 = _group_0_binding_0_cs.camera.delta_y;
    vec3 _e19 = vec3_load(_e18);
    return Camera(_e4, _e9, _e14, _e19);
}

Background picture_background() {
    PackedVec3_ _e3 = _group_0_binding_0_cs.background.dark;
    vec3 _e4 = vec3_load(_e3);
    PackedVec3_ _e8 = _group_0_binding_0_cs.background.light;
    vec3 _e9 = vec3_load(_e8);
    return Background(_e4, _e9);
}

bool is_closer(ClosestHit closest_3, float lambda_5, uint order_1, uint part_2) {
    int _e8 = tie_rank(closest_3.order, (closest_3.part != SIDE));
    int _e11 = tie_rank(order_1, (part_2 != SIDE));
    bool _e15 = tie_is_closer(lambda_5, _e11, closest_3.lambda, _e8);
    return (!(closest_3.some) || _e15);
}

ClosestHit intersect_sphere(ClosestHit closest_4, Ray ray_9, uint index_1) {
    ClosestHit result = ClosestHit(false, 0.0, 0u, false, 0u, 0u);
    PlacedSphere placed = _group_0_binding_1_cs[index_1];
    SphereRecord _e6 = sphere_load(placed);
    Root _e7 = sphere_intersect(_e6, ray_9);
    uint order_2 = placed.order;
    result = closest_4;
    bool _e13 = is_closer(closest_4, _e7.lambda, order_2, SIDE);
    if ((_e7.some && _e13)) {
        result = ClosestHit(true, _e7.lambda, order_2, false, index_1, SIDE);
    }
    ClosestHit _e20 = result;
    return _e20;
}

ClosestHit intersect_cylinder(ClosestHit closest_5, Ray ray_10, uint index_2) {
    ClosestHit result_1 = ClosestHit(false, 0.0, 0u, false, 0u, 0u);
    PlacedCylinder placed_1 = _group_0_binding_2_cs[index_2];
    CylinderRecord _e6 = cylinder_load(placed_1);
    CylinderRoot _e7 = cylinder_intersect(_e6, ray_10);
    uint order_3 = placed_1.order;
    result_1 = closest_5;
    bool _e13 = is_closer(closest_5, _e7.lambda, order_3, _e7.part);
    if ((_e7.some && _e13)) {
        result_1 = ClosestHit(true, _e7.lambda, order_3, true, index_2, _e7.part);
    }
    ClosestHit _e20 = result_1;
    return _e20;
}

SurfaceHit surface_at(ClosestHit closest_6, Ray ray_11) {
    vec3 outward_1 = vec3(0.0);
    uint material_1 = 0u;
    bool local = false;
    bool local_1 = false;
    vec3 _e3 = ray_at(ray_11, closest_6.lambda);
    if (has_spheres) {
        local = !(closest_6.is_cylinder);
    } else {
        local = false;
    }
    bool _e12 = local;
    if (_e12) {
        PlacedSphere _e16 = _group_0_binding_1_cs[closest_6.index];
        SphereRecord _e17 = sphere_load(_e16);
        vec3 _e18 = sphere_outward(_e17, _e3);
        outward_1 = _e18;
        uint _e23 = _group_0_binding_1_cs[closest_6.index].material;
        material_1 = _e23;
    }
    if (has_cylinders) {
        local_1 = closest_6.is_cylinder;
    } else {
        local_1 = false;
    }
    bool _e29 = local_1;
    if (_e29) {
        PlacedCylinder _e33 = _group_0_binding_2_cs[closest_6.index];
        CylinderRecord _e34 = cylinder_load(_e33);
        vec3 _e36 = cylinder_outward(_e34, closest_6.part, _e3);
        outward_1 = _e36;
        uint _e41 = _group_0_binding_2_cs[closest_6.index].material;
        material_1 = _e41;
    }
    vec3 _e43 = outward_1;
    Hit _e44 = hit_facing(ray_11.direction, _e3, _e43);
    uint _e46 = material_1;
    return SurfaceHit(closest_6.some, _e44, _e46, closest_6.lambda, closest_6.order, closest_6.part);
}

ClosestHit intersect_every_object(Ray ray_12) {
    ClosestHit closest_7 = ClosestHit(false, 0.0, 0u, false, 0u, 0u);
    uint index_3 = 0u;
    uint index_4 = 0u;
    if (has_spheres) {
        bool loop_init = true;
        while(true) {
            if (!loop_init) {
                uint _e14 = index_3;
                index_3 = (_e14 + 1u);
            }
            loop_init = false;
            uint _e5 = index_3;
            uint _e8 = _group_0_binding_0_cs.sphere_count;
            if ((_e5 < _e8)) {
            } else {
                break;
            }
            {
                ClosestHit _e10 = closest_7;
                uint _e11 = index_3;
                ClosestHit _e12 = intersect_sphere(_e10, ray_12, _e11);
                closest_7 = _e12;
            }
        }
    }
    if (has_cylinders) {
        bool loop_init_1 = true;
        while(true) {
            if (!loop_init_1) {
                uint _e28 = index_4;
                index_4 = (_e28 + 1u);
            }
            loop_init_1 = false;
            uint _e19 = index_4;
            uint _e22 = _group_0_binding_0_cs.cylinder_count;
            if ((_e19 < _e22)) {
            } else {
                break;
            }
            {
                ClosestHit _e24 = closest_7;
                uint _e25 = index_4;
                ClosestHit _e26 = intersect_cylinder(_e24, ray_12, _e25);
                closest_7 = _e26;
            }
        }
    }
    ClosestHit _e30 = closest_7;
    return _e30;
}

SurfaceHit closest_hit(Ray ray_13) {
    ClosestHit _e1 = intersect_every_object(ray_13);
    SurfaceHit _e2 = surface_at(_e1, ray_13);
    return _e2;
}

bool bounce_attenuates(Material material_2) {
    bool local_2 = false;
    bool local_3 = false;
    bool local_4 = false;
    if (has_matte) {
        local_2 = (material_2.kind == MATTE);
    } else {
        local_2 = false;
    }
    bool _e8 = local_2;
    if (!(_e8)) {
        if (has_metal) {
            local_4 = (material_2.kind == METAL);
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

Ray bounce_ray(Ray ray_14, Hit hit, Material material_3, vec3 scatter_vector) {
    vec3 direction_7 = vec3(0.0);
    bool local_5 = false;
    bool local_6 = false;
    bool local_7 = false;
    if (has_matte) {
        local_5 = (material_3.kind == MATTE);
    } else {
        local_5 = false;
    }
    bool _e12 = local_5;
    if (_e12) {
        vec3 _e14 = scatter_matte(hit.normal, scatter_vector);
        direction_7 = _e14;
    }
    if (has_metal) {
        local_6 = (material_3.kind == METAL);
    } else {
        local_6 = false;
    }
    bool _e22 = local_6;
    if (_e22) {
        vec3 _e25 = scatter_metal(ray_14.direction, hit.normal, scatter_vector);
        direction_7 = _e25;
    }
    if (has_refraction) {
        local_7 = (material_3.kind == REFRACTIVE);
    } else {
        local_7 = false;
    }
    bool _e33 = local_7;
    if (_e33) {
        float _e36 = scatter_index_ratio(material_3.index, hit.front);
        vec3 _e39 = scatter_refract(ray_14.direction, hit.normal, _e36);
        direction_7 = _e39;
    }
    vec3 _e41 = direction_7;
    return Ray(hit.point, _e41);
}

vec3 bounce_attenuated(vec3 color, uint first, uint attenuation_count) {
    vec3 attenuated = vec3(0.0);
    uint left = 0u;
    attenuated = color;
    left = attenuation_count;
    bool loop_init_2 = true;
    while(true) {
        if (!loop_init_2) {
            uint _e23 = left;
            left = (_e23 - 1u);
        }
        loop_init_2 = false;
        uint _e5 = left;
        if ((_e5 > 0u)) {
        } else {
            break;
        }
        {
            vec3 _e8 = attenuated;
            uint _e11 = left;
            uint _e16 = _group_0_binding_4_cs[((first + _e11) - 1u)];
            PackedVec3_ _e19 = _group_0_binding_3_cs[_e16].reflectance;
            vec3 _e20 = vec3_load(_e19);
            attenuated = (_e8 * _e20);
        }
    }
    vec3 _e25 = attenuated;
    return _e25;
}

void trace_path(Ray primary, uint slot) {
    Ray ray_15 = Ray(vec3(0.0), vec3(0.0));
    uint attenuation_count_1 = 0u;
    bool escapes = false;
    uint depth = 0u;
    vec3 color_1 = vec3(0.0);
    ray_15 = primary;
    PackedVec3_ _e5 = _group_0_binding_0_cs.scatter_vector;
    vec3 _e6 = vec3_load(_e5);
    uint first_1 = (slot * max_depth);
    uint _e15 = _group_0_binding_0_cs.first_depth;
    if ((_e15 > 0u)) {
        uint _e21 = _group_0_binding_6_cs[slot].ended;
        if ((_e21 != 0u)) {
            return;
        }
        PackedRay _e27 = _group_0_binding_6_cs[slot].ray;
        Ray _e28 = ray_load(_e27);
        ray_15 = _e28;
        uint _e32 = _group_0_binding_6_cs[slot].attenuation_count;
        attenuation_count_1 = _e32;
    }
    uint _e35 = _group_0_binding_0_cs.first_depth;
    depth = _e35;
    bool loop_init_3 = true;
    while(true) {
        if (!loop_init_3) {
            uint _e67 = depth;
            depth = (_e67 + 1u);
        }
        loop_init_3 = false;
        uint _e37 = depth;
        uint _e41 = _group_0_binding_0_cs.end_depth;
        if ((_e37 < min(max_depth, _e41))) {
        } else {
            break;
        }
        {
            Ray _e44 = ray_15;
            SurfaceHit _e45 = closest_hit(_e44);
            if (!(_e45.some)) {
                escapes = true;
                break;
            }
            PackedMaterial _e52 = _group_0_binding_3_cs[_e45.material];
            Material _e53 = material_load(_e52);
            bool _e54 = bounce_attenuates(_e53);
            if (_e54) {
                uint _e56 = attenuation_count_1;
                _group_0_binding_4_cs[(first_1 + _e56)] = _e45.material;
                uint _e61 = attenuation_count_1;
                attenuation_count_1 = (_e61 + 1u);
            }
            Ray _e63 = ray_15;
            Ray _e65 = bounce_ray(_e63, _e45.hit, _e53, _e6);
            ray_15 = _e65;
        }
    }
    bool _e71 = escapes;
    if (_e71) {
        Background _e72 = picture_background();
        vec3 _e74 = ray_15.direction;
        vec3 _e75 = background_color(_e72, _e74);
        uint _e76 = attenuation_count_1;
        vec3 _e77 = bounce_attenuated(_e75, first_1, _e76);
        color_1 = _e77;
    }
    vec3 _e80 = color_1;
    PackedVec3_ _e81 = vec3_store(_e80);
    _group_0_binding_5_cs[slot] = _e81;
    Ray _e84 = ray_15;
    PackedRay _e85 = ray_store(_e84);
    uint _e86 = attenuation_count_1;
    bool _e89 = escapes;
    _group_0_binding_6_cs[slot] = PackedPath(_e85, _e86, (_e89 ? 1u : 0u));
    return;
}

void main() {
    uvec3 id = gl_GlobalInvocationID;
    uint _e4 = _group_0_binding_0_cs.pixel_count;
    if ((id.x >= _e4)) {
        return;
    }
    uint _e8 = _group_0_binding_0_cs.first_pixel;
    uint pixel = (_e8 + id.x);
    uint _e13 = _group_0_binding_0_cs.width;
    float row_1 = float((pixel / _e13));
    uint _e18 = _group_0_binding_0_cs.width;
    float column_1 = float((pixel % _e18));
    float _e23 = _group_0_binding_0_cs.offset_x;
    float _e26 = _group_0_binding_0_cs.offset_y;
    vec2 offset_1 = vec2(_e23, _e26);
    Camera _e28 = picture_camera();
    Ray _e29 = camera_ray(_e28, row_1, column_1, offset_1);
    trace_path(_e29, id.x);
    bool _e32 = closest_hit_gave_up;
    if (_e32) {
        PackedVec3_ _e38 = vec3_store(vec3(-2.8735182e-16));
        _group_0_binding_5_cs[id.x] = _e38;
        _group_0_binding_6_cs[id.x].ended = 1u;
        return;
    } else {
        return;
    }
}


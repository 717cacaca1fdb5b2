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
struct PlacedSphere {
    PackedVec3_ center;
    float radius;
    float radius_squared;
    uint order;
    uint material;
};
struct PlacedCylinder {
    PackedVec3_ center;
    PackedVec3_ axis;
    PackedVec3_ top;
    PackedVec3_ bottom;
    float radius;
    float radius_squared;
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
struct Step {
    float is_hit;
    float lambda;
    float object;
    float part;
    float front;
    float material;
    PackedVec3_ origin;
    PackedVec3_ direction;
    PackedVec3_ point;
    PackedVec3_ normal;
    PackedVec3_ light;
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

layout(std430, binding = 1) readonly buffer type_4_block_1Compute { PlacedSphere _group_0_binding_1_cs[]; };

layout(std430, binding = 2) readonly buffer type_5_block_2Compute { PlacedCylinder _group_0_binding_2_cs[]; };

layout(std430, binding = 3) readonly buffer type_6_block_3Compute { PackedMaterial _group_0_binding_3_cs[]; };

bool closest_hit_gave_up = false;

layout(std430, binding = 5) buffer type_7_block_4Compute { Step _group_0_binding_5_cs[]; };


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
    bool local = false;
    bool local_1 = false;
    if ((abs(v_3.x) < 1e-8)) {
        local = (abs(v_3.y) < 1e-8);
    } else {
        local = false;
    }
    bool _e11 = local;
    if (_e11) {
        local_1 = (abs(v_3.z) < 1e-8);
    } else {
        local_1 = false;
    }
    bool _e18 = local_1;
    return _e18;
}

vec3 ray_at(Ray ray_1, float lambda) {
    return (ray_1.origin + (ray_1.direction * lambda));
}

bool in_range(float lambda_1) {
    return (0.001 <= lambda_1);
}

Root root_none() {
    return Root(false, 0.0);
}

Hit hit_facing(vec3 direction, vec3 point, vec3 outward) {
    float _e3 = vec3_dot(direction, outward);
    bool front_1 = (_e3 < 0.0);
    if (front_1) {
        return Hit(point, outward, front_1);
    }
    return Hit(point, -(outward), front_1);
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

Root sphere_intersect(SphereRecord sphere_2, Ray ray_2) {
    float _e4 = vec3_dot(ray_2.direction, ray_2.direction);
    SphereView _e6 = sphere_seen_from(sphere_2, ray_2.origin);
    SphereQuadratic _e8 = sphere_quadratic(_e6, ray_2.direction, _e4);
    if ((_e8.discriminant < 0.0)) {
        Root _e12 = root_none();
        return _e12;
    }
    Root _e15 = sphere_first_root(_e4, _e8.h, _e8.discriminant);
    return _e15;
}

bool tie_later_is_closer(float lambda_2, float closest) {
    return (lambda_2 <= closest);
}

bool tie_is_closer(float lambda_3, uint order, float closest_1, uint closest_order) {
    bool local_2 = false;
    bool local_3 = false;
    bool _e4 = tie_later_is_closer(lambda_3, closest_1);
    if (_e4) {
        if (!((lambda_3 < closest_1))) {
            local_3 = (order >= closest_order);
        } else {
            local_3 = true;
        }
        bool _e13 = local_3;
        local_2 = _e13;
    } else {
        local_2 = false;
    }
    bool _e15 = local_2;
    return _e15;
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

bool cylinder_within_height(CylinderRecord cylinder_2, Ray ray_3, float lambda_4) {
    vec3 _e3 = ray_at(ray_3, lambda_4);
    float _e7 = vec3_dot((_e3 - cylinder_2.center), cylinder_2.axis);
    return (abs(_e7) <= cylinder_2.half_height);
}

Root cylinder_side(CylinderRecord cylinder_3, Ray ray_4, CylinderQuadratic quadratic) {
    bool local_4 = false;
    bool local_5 = false;
    bool local_6 = false;
    float root_1 = sqrt(quadratic.discriminant);
    float near_1 = ((-(quadratic.h) - root_1) / quadratic.a);
    float far_1 = ((-(quadratic.h) + root_1) / quadratic.a);
    bool _e15 = in_range(near_1);
    if (_e15) {
        bool _e18 = cylinder_within_height(cylinder_3, ray_4, near_1);
        local_4 = _e18;
    } else {
        local_4 = false;
    }
    bool near_counts = local_4;
    bool _e21 = in_range(far_1);
    if (_e21) {
        bool _e24 = cylinder_within_height(cylinder_3, ray_4, far_1);
        local_5 = _e24;
    } else {
        local_5 = false;
    }
    bool far_counts = local_5;
    if (!(near_counts)) {
        local_6 = far_counts;
    } else {
        local_6 = true;
    }
    bool _e31 = local_6;
    return Root(_e31, (near_counts ? near_1 : far_1));
}

Root cylinder_cap(CylinderRecord cylinder_4, Ray ray_5, vec3 center) {
    bool local_7 = false;
    bool local_8 = false;
    float _e5 = vec3_dot(ray_5.direction, cylinder_4.axis);
    float _e9 = vec3_dot((center - ray_5.origin), cylinder_4.axis);
    float lambda_7 = (_e9 / _e5);
    vec3 _e11 = ray_at(ray_5, lambda_7);
    float _e13 = vec3_length((_e11 - center));
    bool on_disc = (_e13 <= cylinder_4.radius);
    if (!((abs(_e5) < 1e-8))) {
        bool _e22 = in_range(lambda_7);
        local_7 = _e22;
    } else {
        local_7 = false;
    }
    bool _e24 = local_7;
    if (_e24) {
        local_8 = on_disc;
    } else {
        local_8 = false;
    }
    bool _e28 = local_8;
    return Root(_e28, lambda_7);
}

vec3 cylinder_outward(CylinderRecord cylinder_5, uint part, vec3 point_2) {
    switch(part) {
        case 0u: {
            vec3 _e6 = vec3_perpendicular_to((point_2 - cylinder_5.center), cylinder_5.axis);
            return _e6;
        }
        case 1u: {
            return cylinder_5.axis;
        }
        default: {
            return -(cylinder_5.axis);
        }
    }
}

CylinderRoot cylinder_with_caps(CylinderRecord cylinder_6, Ray ray_6, Root side) {
    CylinderRoot closest_2 = CylinderRoot(false, 0.0, 0u);
    bool local_9 = false;
    bool local_10 = false;
    bool local_11 = false;
    bool local_12 = false;
    closest_2 = CylinderRoot(side.some, side.lambda, SIDE);
    Root _e9 = cylinder_cap(cylinder_6, ray_6, cylinder_6.top);
    if (_e9.some) {
        bool _e14 = closest_2.some;
        if (!(!(_e14))) {
            float _e21 = closest_2.lambda;
            bool _e22 = tie_later_is_closer(_e9.lambda, _e21);
            local_10 = _e22;
        } else {
            local_10 = true;
        }
        bool _e24 = local_10;
        local_9 = _e24;
    } else {
        local_9 = false;
    }
    bool _e26 = local_9;
    if (_e26) {
        closest_2 = CylinderRoot(true, _e9.lambda, TOP);
    }
    Root _e32 = cylinder_cap(cylinder_6, ray_6, cylinder_6.bottom);
    if (_e32.some) {
        bool _e37 = closest_2.some;
        if (!(!(_e37))) {
            float _e44 = closest_2.lambda;
            bool _e45 = tie_later_is_closer(_e32.lambda, _e44);
            local_12 = _e45;
        } else {
            local_12 = true;
        }
        bool _e47 = local_12;
        local_11 = _e47;
    } else {
        local_11 = false;
    }
    bool _e49 = local_11;
    if (_e49) {
        closest_2 = CylinderRoot(true, _e32.lambda, BOTTOM);
    }
    CylinderRoot _e54 = closest_2;
    return _e54;
}

CylinderRoot cylinder_intersect(CylinderRecord cylinder_7, Ray ray_7) {
    Root side_1 = Root(false, 0.0);
    CylinderView _e3 = cylinder_seen_from(cylinder_7, ray_7.origin);
    CylinderQuadratic _e5 = cylinder_quadratic(cylinder_7, _e3, ray_7.direction);
    if (!((_e5.discriminant < 0.0))) {
        Root _e11 = cylinder_side(cylinder_7, ray_7, _e5);
        side_1 = _e11;
    }
    Root _e12 = side_1;
    CylinderRoot _e13 = cylinder_with_caps(cylinder_7, ray_7, _e12);
    return _e13;
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
    if (_e3) {
        return normal;
    }
    return direction_8;
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

SphereRecord sphere_load(PlacedSphere sphere_3) {
    vec3 _e2 = vec3_load(sphere_3.center);
    return SphereRecord(_e2, sphere_3.radius, sphere_3.radius_squared);
}

CylinderRecord cylinder_load(PlacedCylinder cylinder_8) {
    vec3 _e2 = vec3_load(cylinder_8.center);
    vec3 _e4 = vec3_load(cylinder_8.axis);
    vec3 _e6 = vec3_load(cylinder_8.top);
    vec3 _e8 = vec3_load(cylinder_8.bottom);
    return CylinderRecord(_e2, _e4, _e6, _e8, cylinder_8.radius, cylinder_8.radius_squared, cylinder_8.half_height);
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

bool is_closer(ClosestHit closest_3, float lambda_5, uint order_1) {
    bool local_13 = false;
    if (!(!(closest_3.some))) {
        bool _e10 = tie_is_closer(lambda_5, order_1, closest_3.lambda, closest_3.order);
        local_13 = _e10;
    } else {
        local_13 = true;
    }
    bool _e12 = local_13;
    return _e12;
}

ClosestHit intersect_sphere(ClosestHit closest_4, Ray ray_8, uint index_1) {
    bool local_14 = false;
    PlacedSphere _e5 = _group_0_binding_1_cs[index_1];
    SphereRecord _e6 = sphere_load(_e5);
    Root _e7 = sphere_intersect(_e6, ray_8);
    uint order_2 = _group_0_binding_1_cs[index_1].order;
    if (_e7.some) {
        bool _e16 = is_closer(closest_4, _e7.lambda, order_2);
        local_14 = _e16;
    } else {
        local_14 = false;
    }
    bool _e18 = local_14;
    if (_e18) {
        return ClosestHit(true, _e7.lambda, order_2, false, index_1, SIDE);
    }
    return closest_4;
}

ClosestHit intersect_cylinder(ClosestHit closest_5, Ray ray_9, uint index_2) {
    bool local_15 = false;
    PlacedCylinder _e5 = _group_0_binding_2_cs[index_2];
    CylinderRecord _e6 = cylinder_load(_e5);
    CylinderRoot _e7 = cylinder_intersect(_e6, ray_9);
    uint order_3 = _group_0_binding_2_cs[index_2].order;
    if (_e7.some) {
        bool _e16 = is_closer(closest_5, _e7.lambda, order_3);
        local_15 = _e16;
    } else {
        local_15 = false;
    }
    bool _e18 = local_15;
    if (_e18) {
        return ClosestHit(true, _e7.lambda, order_3, true, index_2, _e7.part);
    }
    return closest_5;
}

SurfaceHit surface_at(ClosestHit closest_6, Ray ray_10) {
    SurfaceHit surface = SurfaceHit(false, Hit(vec3(0.0), vec3(0.0), false), 0u, 0.0, 0u, 0u);
    bool local_16 = false;
    bool local_17 = false;
    if (!(closest_6.some)) {
        SurfaceHit _e5 = surface;
        return _e5;
    }
    vec3 _e7 = ray_at(ray_10, closest_6.lambda);
    if (has_spheres) {
        local_16 = !(closest_6.is_cylinder);
    } else {
        local_16 = false;
    }
    bool _e14 = local_16;
    if (_e14) {
        PlacedSphere _e18 = _group_0_binding_1_cs[closest_6.index];
        SphereRecord _e19 = sphere_load(_e18);
        vec3 _e20 = sphere_outward(_e19, _e7);
        Hit _e22 = hit_facing(ray_10.direction, _e7, _e20);
        uint material_2 = _group_0_binding_1_cs[closest_6.index].material;
        surface = SurfaceHit(true, _e22, material_2, closest_6.lambda, closest_6.order, closest_6.part);
    }
    if (has_cylinders) {
        local_17 = closest_6.is_cylinder;
    } else {
        local_17 = false;
    }
    bool _e38 = local_17;
    if (_e38) {
        PlacedCylinder _e42 = _group_0_binding_2_cs[closest_6.index];
        CylinderRecord _e43 = cylinder_load(_e42);
        vec3 _e45 = cylinder_outward(_e43, closest_6.part, _e7);
        Hit _e47 = hit_facing(ray_10.direction, _e7, _e45);
        uint material_3 = _group_0_binding_2_cs[closest_6.index].material;
        surface = SurfaceHit(true, _e47, material_3, closest_6.lambda, closest_6.order, closest_6.part);
    }
    SurfaceHit _e58 = surface;
    return _e58;
}

ClosestHit intersect_every_object(Ray ray_11) {
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
                ClosestHit _e12 = intersect_sphere(_e10, ray_11, _e11);
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
                ClosestHit _e26 = intersect_cylinder(_e24, ray_11, _e25);
                closest_7 = _e26;
            }
        }
    }
    ClosestHit _e30 = closest_7;
    return _e30;
}

SurfaceHit closest_hit(Ray ray_12) {
    ClosestHit _e1 = intersect_every_object(ray_12);
    SurfaceHit _e2 = surface_at(_e1, ray_12);
    return _e2;
}

Ray bounce_ray(Ray ray_13, Hit hit, Material material_1, vec3 scatter_vector) {
    vec3 direction_7 = vec3(0.0);
    bool local_18 = false;
    bool local_19 = false;
    bool local_20 = false;
    if (has_matte) {
        local_18 = (material_1.kind == MATTE);
    } else {
        local_18 = false;
    }
    bool _e12 = local_18;
    if (_e12) {
        vec3 _e14 = scatter_matte(hit.normal, scatter_vector);
        direction_7 = _e14;
    }
    if (has_metal) {
        local_19 = (material_1.kind == METAL);
    } else {
        local_19 = false;
    }
    bool _e22 = local_19;
    if (_e22) {
        vec3 _e25 = scatter_metal(ray_13.direction, hit.normal, scatter_vector);
        direction_7 = _e25;
    }
    if (has_refraction) {
        local_20 = (material_1.kind == REFRACTIVE);
    } else {
        local_20 = false;
    }
    bool _e33 = local_20;
    if (_e33) {
        float _e36 = scatter_index_ratio(material_1.index, hit.front);
        vec3 _e39 = scatter_refract(ray_13.direction, hit.normal, _e36);
        direction_7 = _e39;
    }
    vec3 _e41 = direction_7;
    return Ray(hit.point, _e41);
}

void main() {
    uvec3 id = gl_GlobalInvocationID;
    Ray ray = Ray(vec3(0.0), vec3(0.0));
    bool ended = false;
    uint depth = 0u;
    Step step_ = Step(0.0, 0.0, 0.0, 0.0, 0.0, 0.0, PackedVec3_(0.0, 0.0, 0.0), PackedVec3_(0.0, 0.0, 0.0), PackedVec3_(0.0, 0.0, 0.0), PackedVec3_(0.0, 0.0, 0.0), PackedVec3_(0.0, 0.0, 0.0));
    uint _e4 = _group_0_binding_0_cs.pixel_count;
    if ((id.x >= _e4)) {
        return;
    }
    uint _e8 = _group_0_binding_0_cs.first_pixel;
    uint pixel = (_e8 + id.x);
    float _e13 = _group_0_binding_0_cs.offset_x;
    float _e16 = _group_0_binding_0_cs.offset_y;
    vec2 offset_1 = vec2(_e13, _e16);
    PackedVec3_ _e20 = _group_0_binding_0_cs.scatter_vector;
    vec3 _e21 = vec3_load(_e20);
    Camera _e22 = picture_camera();
    uint _e25 = _group_0_binding_0_cs.width;
    uint _e30 = _group_0_binding_0_cs.width;
    Ray _e33 = camera_ray(_e22, float((pixel / _e25)), float((pixel % _e30)), offset_1);
    ray = _e33;
    uint _e39 = _group_0_binding_0_cs.first_depth;
    if ((_e39 > 0u)) {
        uint _e48 = _group_0_binding_0_cs.first_depth;
        Step last = _group_0_binding_5_cs[(((id.x * max_depth) + _e48) - 1u)];
        ended = (last.is_hit != 1.0);
        vec3 _e58 = vec3_load(last.origin);
        vec3 _e60 = vec3_load(last.direction);
        ray = Ray(_e58, _e60);
        bool _e62 = ended;
        if (!(_e62)) {
            vec3 _e65 = vec3_load(last.point);
            vec3 _e67 = vec3_load(last.normal);
            Hit hit_1 = Hit(_e65, _e67, (last.front == 1.0));
            Ray _e72 = ray;
            PackedMaterial _e77 = _group_0_binding_3_cs[uint(last.material)];
            Material _e78 = material_load(_e77);
            Ray _e79 = bounce_ray(_e72, hit_1, _e78, _e21);
            ray = _e79;
        }
    }
    uint _e82 = _group_0_binding_0_cs.first_depth;
    depth = _e82;
    bool loop_init_2 = true;
    while(true) {
        if (!loop_init_2) {
            uint _e162 = depth;
            depth = (_e162 + 1u);
        }
        loop_init_2 = false;
        uint _e84 = depth;
        uint _e88 = _group_0_binding_0_cs.end_depth;
        if ((_e84 < min(max_depth, _e88))) {
        } else {
            break;
        }
        {
            step_ = Step(0.0, 0.0, 0.0, 0.0, 0.0, 0.0, PackedVec3_(0.0, 0.0, 0.0), PackedVec3_(0.0, 0.0, 0.0), PackedVec3_(0.0, 0.0, 0.0), PackedVec3_(0.0, 0.0, 0.0), PackedVec3_(0.0, 0.0, 0.0));
            bool _e93 = ended;
            if (_e93) {
                step_.is_hit = -1.0;
            } else {
                vec3 _e98 = ray.origin;
                PackedVec3_ _e99 = vec3_store(_e98);
                step_.origin = _e99;
                vec3 _e102 = ray.direction;
                PackedVec3_ _e103 = vec3_store(_e102);
                step_.direction = _e103;
                Ray _e104 = ray;
                SurfaceHit _e105 = closest_hit(_e104);
                if (_e105.some) {
                    step_.is_hit = 1.0;
                    step_.lambda = _e105.lambda;
                    step_.object = float(_e105.order);
                    step_.part = float(_e105.part);
                    step_.front = (_e105.hit.front ? 1.0 : 0.0);
                    step_.material = float(_e105.material);
                    PackedVec3_ _e129 = vec3_store(_e105.hit.point);
                    step_.point = _e129;
                    PackedVec3_ _e133 = vec3_store(_e105.hit.normal);
                    step_.normal = _e133;
                    Ray _e134 = ray;
                    PackedMaterial _e139 = _group_0_binding_3_cs[_e105.material];
                    Material _e140 = material_load(_e139);
                    Ray _e141 = bounce_ray(_e134, _e105.hit, _e140, _e21);
                    ray = _e141;
                } else {
                    Background _e143 = picture_background();
                    vec3 _e145 = ray.direction;
                    vec3 _e146 = background_color(_e143, _e145);
                    PackedVec3_ _e147 = vec3_store(_e146);
                    step_.light = _e147;
                    ended = true;
                }
            }
            bool _e150 = closest_hit_gave_up;
            if (_e150) {
                step_.is_hit = UNWRITTEN;
            }
            uint _e157 = depth;
            Step _e160 = step_;
            _group_0_binding_5_cs[((id.x * max_depth) + _e157)] = _e160;
        }
    }
    return;
}


#version 430 core
#extension GL_ARB_compute_shader : require
#extension GL_ARB_shader_storage_buffer_object : require
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
struct CylinderRecord {
    vec3 center;
    vec3 axis;
    vec3 top;
    vec3 bottom;
    float radius;
    float radius_squared;
    float half_height;
};
struct CylinderQuadratic {
    float a;
    float h;
    float discriminant;
};
struct PlaneMeeting {
    float lambda;
    float slope;
};
struct CylinderRoot {
    bool some;
    float lambda;
    uint part;
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
struct HitReport {
    float some;
    float lambda;
    float part;
    float front;
    PackedVec3_ point;
    PackedVec3_ normal;
};
struct CylinderCase {
    PackedRay ray;
    PackedVec3_ center;
    float radius;
    PackedVec3_ axis;
};
const uint SIDE = 0u;
const uint TOP = 1u;
const uint BOTTOM = 2u;

layout(std430, binding = 0) readonly buffer type_3_block_0Compute { CylinderCase _group_0_binding_0_cs[]; };

layout(std430, binding = 1) buffer type_4_block_1Compute { HitReport _group_0_binding_1_cs[]; };


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

vec3 ray_at(Ray ray, float lambda) {
    return (ray.origin + (ray.direction * lambda));
}

bool in_range(float lambda_1) {
    return (0.001 <= lambda_1);
}

Root root_none() {
    return Root(false, 0.0);
}

Root root_when(bool counts, float lambda_2) {
    if (counts) {
        return Root(true, lambda_2);
    }
    Root _e4 = root_none();
    return _e4;
}

Hit hit_facing(vec3 direction, vec3 point, vec3 outward) {
    float _e3 = vec3_dot(direction, outward);
    bool front = (_e3 < 0.0);
    if (front) {
        return Hit(point, outward, front);
    }
    return Hit(point, -(outward), front);
}

CylinderRecord cylinder_new(vec3 center, float radius, vec3 axis_1) {
    float _e3 = vec3_length(axis_1);
    vec3 unit = (axis_1 / vec3(_e3));
    float half_height = (_e3 / 2.0);
    vec3 reach = (unit * half_height);
    vec3 top = (center + reach);
    vec3 bottom = (center - reach);
    return CylinderRecord(center, unit, top, bottom, radius, (radius * radius), half_height);
}

CylinderQuadratic cylinder_quadratic(CylinderRecord cylinder_1, Ray ray_1) {
    vec3 _e4 = vec3_perpendicular_to(ray_1.direction, cylinder_1.axis);
    vec3 _e9 = vec3_perpendicular_to((ray_1.origin - cylinder_1.center), cylinder_1.axis);
    float _e10 = vec3_dot(_e4, _e4);
    float _e11 = vec3_dot(_e9, _e4);
    float _e12 = vec3_dot(_e9, _e9);
    float c = (_e12 - cylinder_1.radius_squared);
    return CylinderQuadratic(_e10, _e11, ((_e11 * _e11) - (_e10 * c)));
}

bool cylinder_within_height(CylinderRecord cylinder_2, Ray ray_2, float lambda_3) {
    vec3 _e3 = ray_at(ray_2, lambda_3);
    float _e7 = vec3_dot((_e3 - cylinder_2.center), cylinder_2.axis);
    return (abs(_e7) <= cylinder_2.half_height);
}

PlaneMeeting cylinder_plane(CylinderRecord cylinder_3, Ray ray_3, vec3 base) {
    float _e5 = vec3_dot(ray_3.direction, cylinder_3.axis);
    float _e9 = vec3_dot((base - ray_3.origin), cylinder_3.axis);
    return PlaneMeeting((_e9 / _e5), _e5);
}

bool cylinder_on_disc(CylinderRecord cylinder_4, Ray ray_4, vec3 base_1, float lambda_4) {
    vec3 _e4 = ray_at(ray_4, lambda_4);
    float _e6 = vec3_length((_e4 - base_1));
    return (_e6 <= cylinder_4.radius);
}

vec3 cylinder_outward(CylinderRecord cylinder_5, uint part, vec3 point_1) {
    switch(part) {
        case 0u: {
            vec3 _e6 = vec3_perpendicular_to((point_1 - cylinder_5.center), cylinder_5.axis);
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

Root cylinder_side(CylinderRecord cylinder_6, Ray ray_5) {
    bool local_2 = false;
    bool local_3 = false;
    CylinderQuadratic _e2 = cylinder_quadratic(cylinder_6, ray_5);
    if ((_e2.discriminant < 0.0)) {
        Root _e6 = root_none();
        return _e6;
    }
    float root = sqrt(_e2.discriminant);
    float near = ((-(_e2.h) - root) / _e2.a);
    bool _e14 = in_range(near);
    if (_e14) {
        bool _e17 = cylinder_within_height(cylinder_6, ray_5, near);
        local_2 = _e17;
    } else {
        local_2 = false;
    }
    bool _e19 = local_2;
    if (_e19) {
        return Root(true, near);
    }
    float far = ((-(_e2.h) + root) / _e2.a);
    bool _e27 = in_range(far);
    if (_e27) {
        bool _e30 = cylinder_within_height(cylinder_6, ray_5, far);
        local_3 = _e30;
    } else {
        local_3 = false;
    }
    bool _e32 = local_3;
    Root _e33 = root_when(_e32, far);
    return _e33;
}

Root cylinder_base(CylinderRecord cylinder_7, Ray ray_6, vec3 base_2) {
    bool local_4 = false;
    PlaneMeeting _e3 = cylinder_plane(cylinder_7, ray_6, base_2);
    if ((abs(_e3.slope) < 1e-8)) {
        Root _e8 = root_none();
        return _e8;
    }
    bool _e10 = in_range(_e3.lambda);
    if (_e10) {
        bool _e14 = cylinder_on_disc(cylinder_7, ray_6, base_2, _e3.lambda);
        local_4 = _e14;
    } else {
        local_4 = false;
    }
    bool _e16 = local_4;
    Root _e18 = root_when(_e16, _e3.lambda);
    return _e18;
}

CylinderRoot cylinder_intersect(CylinderRecord cylinder_8, Ray ray_7) {
    CylinderRoot nearest = CylinderRoot(false, 0.0, 0u);
    bool local_5 = false;
    bool local_6 = false;
    bool local_7 = false;
    bool local_8 = false;
    Root _e2 = cylinder_side(cylinder_8, ray_7);
    nearest = CylinderRoot(_e2.some, _e2.lambda, SIDE);
    Root _e9 = cylinder_base(cylinder_8, ray_7, cylinder_8.top);
    if (_e9.some) {
        bool _e14 = nearest.some;
        if (!(!(_e14))) {
            float _e21 = nearest.lambda;
            local_6 = (_e9.lambda <= _e21);
        } else {
            local_6 = true;
        }
        bool _e24 = local_6;
        local_5 = _e24;
    } else {
        local_5 = false;
    }
    bool _e26 = local_5;
    if (_e26) {
        nearest = CylinderRoot(true, _e9.lambda, TOP);
    }
    Root _e32 = cylinder_base(cylinder_8, ray_7, cylinder_8.bottom);
    if (_e32.some) {
        bool _e37 = nearest.some;
        if (!(!(_e37))) {
            float _e44 = nearest.lambda;
            local_8 = (_e32.lambda <= _e44);
        } else {
            local_8 = true;
        }
        bool _e47 = local_8;
        local_7 = _e47;
    } else {
        local_7 = false;
    }
    bool _e49 = local_7;
    if (_e49) {
        nearest = CylinderRoot(true, _e32.lambda, BOTTOM);
    }
    CylinderRoot _e54 = nearest;
    return _e54;
}

vec3 vec3_load(PackedVec3_ v_4) {
    return vec3(v_4.x, v_4.y, v_4.z);
}

PackedVec3_ vec3_store(vec3 v_5) {
    return PackedVec3_(v_5.x, v_5.y, v_5.z);
}

Ray ray_load(PackedRay ray_8) {
    vec3 _e2 = vec3_load(ray_8.origin);
    vec3 _e4 = vec3_load(ray_8.direction);
    return Ray(_e2, _e4);
}

HitReport hit_report_none() {
    PackedVec3_ _e1 = vec3_store(vec3(0.0));
    return HitReport(0.0, 0.0, 0.0, 0.0, _e1, _e1);
}

HitReport hit_report(float lambda_5, uint part_1, Hit hit) {
    float front_1 = (hit.front ? 1.0 : 0.0);
    PackedVec3_ _e10 = vec3_store(hit.point);
    PackedVec3_ _e12 = vec3_store(hit.normal);
    return HitReport(1.0, lambda_5, float(part_1), front_1, _e10, _e12);
}

void main() {
    uvec3 id = gl_GlobalInvocationID;
    if ((id.x >= uint(_group_0_binding_0_cs.length()))) {
        return;
    }
    PackedRay _e9 = _group_0_binding_0_cs[id.x].ray;
    Ray _e10 = ray_load(_e9);
    PackedVec3_ _e15 = _group_0_binding_0_cs[id.x].center;
    vec3 _e16 = vec3_load(_e15);
    float _e21 = _group_0_binding_0_cs[id.x].radius;
    PackedVec3_ _e26 = _group_0_binding_0_cs[id.x].axis;
    vec3 _e27 = vec3_load(_e26);
    CylinderRecord _e28 = cylinder_new(_e16, _e21, _e27);
    CylinderRoot _e29 = cylinder_intersect(_e28, _e10);
    if (!(_e29.some)) {
        HitReport _e35 = hit_report_none();
        _group_0_binding_1_cs[id.x] = _e35;
        return;
    }
    vec3 _e37 = ray_at(_e10, _e29.lambda);
    vec3 _e40 = cylinder_outward(_e28, _e29.part, _e37);
    Hit _e41 = hit_facing(_e10.direction, _e37, _e40);
    HitReport _e47 = hit_report(_e29.lambda, _e29.part, _e41);
    _group_0_binding_1_cs[id.x] = _e47;
    return;
}


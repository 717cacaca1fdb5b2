// language: metal2.0
#include <metal_stdlib>
#include <simd/simd.h>

using metal::uint;

struct _mslBufferSizes {
    uint size0;
    uint size1;
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
struct CylinderQuadratic {
    real a;
    real h;
    real discriminant;
};
struct PlaneMeeting {
    real lambda;
    real slope;
};
struct CylinderRoot {
    bool some;
    char _pad1[3];
    real lambda;
    uint part;
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
struct HitReport {
    real some;
    real lambda;
    real part;
    real front;
    PackedVec3_ point;
    PackedVec3_ normal;
};
struct CylinderCase {
    PackedRay ray;
    PackedVec3_ center;
    real radius;
    PackedVec3_ axis;
};
typedef CylinderCase type_3[1];
typedef HitReport type_4[1];
constant uint SIDE = 0u;
constant uint TOP = 1u;
constant uint BOTTOM = 2u;

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
    bool local = {};
    bool local_1 = {};
    if (metal::abs(v_3.x) < 0.00000001) {
        local = metal::abs(v_3.y) < 0.00000001;
    } else {
        local = false;
    }
    bool _e11 = local;
    if (_e11) {
        local_1 = metal::abs(v_3.z) < 0.00000001;
    } else {
        local_1 = false;
    }
    bool _e18 = local_1;
    return _e18;
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

Root root_none(
) {
    return Root {false, {}, 0.0};
}

Root root_when(
    bool counts,
    real lambda_2
) {
    if (counts) {
        return Root {true, {}, lambda_2};
    }
    Root _e4 = root_none();
    return _e4;
}

Hit hit_facing(
    metal::float3 direction,
    metal::float3 point,
    metal::float3 outward
) {
    real _e3 = vec3_dot(direction, outward);
    bool front = _e3 < 0.0;
    if (front) {
        return Hit {point, outward, front};
    }
    return Hit {point, -(outward), front};
}

CylinderRecord cylinder_new(
    metal::float3 center,
    real radius,
    metal::float3 axis_1
) {
    real _e3 = vec3_length(axis_1);
    metal::float3 unit = axis_1 / metal::float3(_e3);
    real half_height = _e3 / 2.0;
    metal::float3 reach = unit * half_height;
    metal::float3 top = center + reach;
    metal::float3 bottom = center - reach;
    return CylinderRecord {center, unit, top, bottom, radius, radius * radius, half_height};
}

CylinderQuadratic cylinder_quadratic(
    CylinderRecord cylinder_1,
    Ray ray_1
) {
    metal::float3 _e4 = vec3_perpendicular_to(ray_1.direction, cylinder_1.axis);
    metal::float3 _e9 = vec3_perpendicular_to(ray_1.origin - cylinder_1.center, cylinder_1.axis);
    real _e10 = vec3_dot(_e4, _e4);
    real _e11 = vec3_dot(_e9, _e4);
    real _e12 = vec3_dot(_e9, _e9);
    real c = _e12 - cylinder_1.radius_squared;
    return CylinderQuadratic {_e10, _e11, (_e11 * _e11) - (_e10 * c)};
}

bool cylinder_within_height(
    CylinderRecord cylinder_2,
    Ray ray_2,
    real lambda_3
) {
    metal::float3 _e3 = ray_at(ray_2, lambda_3);
    real _e7 = vec3_dot(_e3 - cylinder_2.center, cylinder_2.axis);
    return metal::abs(_e7) <= cylinder_2.half_height;
}

PlaneMeeting cylinder_plane(
    CylinderRecord cylinder_3,
    Ray ray_3,
    metal::float3 base
) {
    real _e5 = vec3_dot(ray_3.direction, cylinder_3.axis);
    real _e9 = vec3_dot(base - ray_3.origin, cylinder_3.axis);
    return PlaneMeeting {_e9 / _e5, _e5};
}

bool cylinder_on_disc(
    CylinderRecord cylinder_4,
    Ray ray_4,
    metal::float3 base_1,
    real lambda_4
) {
    metal::float3 _e4 = ray_at(ray_4, lambda_4);
    real _e6 = vec3_length(_e4 - base_1);
    return _e6 <= cylinder_4.radius;
}

metal::float3 cylinder_outward(
    CylinderRecord cylinder_5,
    uint part,
    metal::float3 point_1
) {
    switch(part) {
        case 0u: {
            metal::float3 _e6 = vec3_perpendicular_to(point_1 - cylinder_5.center, cylinder_5.axis);
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

Root cylinder_side(
    CylinderRecord cylinder_6,
    Ray ray_5
) {
    bool local_2 = {};
    bool local_3 = {};
    CylinderQuadratic _e2 = cylinder_quadratic(cylinder_6, ray_5);
    if (_e2.discriminant < 0.0) {
        Root _e6 = root_none();
        return _e6;
    }
    float root = metal::sqrt(_e2.discriminant);
    real near = (-(_e2.h) - root) / _e2.a;
    bool _e14 = in_range(near);
    if (_e14) {
        bool _e17 = cylinder_within_height(cylinder_6, ray_5, near);
        local_2 = _e17;
    } else {
        local_2 = false;
    }
    bool _e19 = local_2;
    if (_e19) {
        return Root {true, {}, near};
    }
    real far = (-(_e2.h) + root) / _e2.a;
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

Root cylinder_base(
    CylinderRecord cylinder_7,
    Ray ray_6,
    metal::float3 base_2
) {
    bool local_4 = {};
    PlaneMeeting _e3 = cylinder_plane(cylinder_7, ray_6, base_2);
    if (metal::abs(_e3.slope) < 0.00000001) {
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

CylinderRoot cylinder_intersect(
    CylinderRecord cylinder_8,
    Ray ray_7
) {
    CylinderRoot nearest = {};
    bool local_5 = {};
    bool local_6 = {};
    bool local_7 = {};
    bool local_8 = {};
    Root _e2 = cylinder_side(cylinder_8, ray_7);
    nearest = CylinderRoot {_e2.some, {}, _e2.lambda, SIDE};
    Root _e9 = cylinder_base(cylinder_8, ray_7, cylinder_8.top);
    if (_e9.some) {
        bool _e14 = nearest.some;
        if (!(!(_e14))) {
            real _e21 = nearest.lambda;
            local_6 = _e9.lambda <= _e21;
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
        nearest = CylinderRoot {true, {}, _e9.lambda, TOP};
    }
    Root _e32 = cylinder_base(cylinder_8, ray_7, cylinder_8.bottom);
    if (_e32.some) {
        bool _e37 = nearest.some;
        if (!(!(_e37))) {
            real _e44 = nearest.lambda;
            local_8 = _e32.lambda <= _e44;
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
        nearest = CylinderRoot {true, {}, _e32.lambda, BOTTOM};
    }
    CylinderRoot _e54 = nearest;
    return _e54;
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
    PackedRay ray_8
) {
    metal::float3 _e2 = vec3_load(ray_8.origin);
    metal::float3 _e4 = vec3_load(ray_8.direction);
    return Ray {_e2, _e4};
}

HitReport hit_report_none(
) {
    PackedVec3_ _e1 = vec3_store(metal::float3 {});
    return HitReport {0.0, 0.0, 0.0, 0.0, _e1, _e1};
}

HitReport hit_report(
    real lambda_5,
    uint part_1,
    Hit hit
) {
    float front_1 = hit.front ? 1.0 : 0.0;
    PackedVec3_ _e10 = vec3_store(hit.point);
    PackedVec3_ _e12 = vec3_store(hit.normal);
    return HitReport {1.0, lambda_5, static_cast<float>(part_1), front_1, _e10, _e12};
}

struct cylinderInput {
};
kernel void cylinder(
  metal::uint3 id [[thread_position_in_grid]]
, device type_3 const& cases [[buffer(0)]]
, device type_4& reports [[buffer(1)]]
, constant _mslBufferSizes& _buffer_sizes [[buffer(2)]]
) {
    if (id.x >= (1 + (_buffer_sizes.size0 - 0 - 52) / 52)) {
        return;
    }
    PackedRay _e9 = cases[id.x].ray;
    Ray _e10 = ray_load(_e9);
    PackedVec3_ _e15 = cases[id.x].center;
    metal::float3 _e16 = vec3_load(_e15);
    real _e21 = cases[id.x].radius;
    PackedVec3_ _e26 = cases[id.x].axis;
    metal::float3 _e27 = vec3_load(_e26);
    CylinderRecord _e28 = cylinder_new(_e16, _e21, _e27);
    CylinderRoot _e29 = cylinder_intersect(_e28, _e10);
    if (!(_e29.some)) {
        HitReport _e35 = hit_report_none();
        reports[id.x] = _e35;
        return;
    }
    metal::float3 _e37 = ray_at(_e10, _e29.lambda);
    metal::float3 _e40 = cylinder_outward(_e28, _e29.part, _e37);
    Hit _e41 = hit_facing(_e10.direction, _e37, _e40);
    HitReport _e47 = hit_report(_e29.lambda, _e29.part, _e41);
    reports[id.x] = _e47;
    return;
}

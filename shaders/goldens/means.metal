// language: metal2.0
#include <metal_stdlib>
#include <simd/simd.h>

using metal::uint;

struct _mslBufferSizes {
    uint size1;
    uint size2;
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
struct PackedVec3_ {
    real x;
    real y;
    real z;
};
struct PackedRay {
    PackedVec3_ origin;
    PackedVec3_ direction;
};
struct TracedSample {
    PackedVec3_ color;
    uint words;
    uint unused;
};
struct type_3 {
    PackedVec3_ inner[2];
};
struct Accumulation {
    type_3 starts;
    uint first_sample;
    uint sample_count;
    uint samples_per_pixel;
    uint unused;
};
typedef TracedSample type_4[1];
typedef PackedVec3_ type_5[1];
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
    bool front = _e3 < 0.0;
    return Hit {point, front ? outward : -(outward), front};
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
    PackedRay ray_1
) {
    metal::float3 _e2 = vec3_load(ray_1.origin);
    metal::float3 _e4 = vec3_load(ray_1.direction);
    return Ray {_e2, _e4};
}

PackedRay ray_store(
    Ray ray_2
) {
    PackedVec3_ _e2 = vec3_store(ray_2.origin);
    PackedVec3_ _e4 = vec3_store(ray_2.direction);
    return PackedRay {_e2, _e4};
}

struct meansInput {
};
kernel void means(
  metal::uint3 id [[thread_position_in_grid]]
, device Accumulation const& accumulation [[buffer(0)]]
, device type_4 const& samples [[buffer(1)]]
, device type_5& means_of_pixels [[buffer(2)]]
, constant _mslBufferSizes& _buffer_sizes [[buffer(3)]]
) {
    metal::float3 sum = {};
    uint sample = {};
    if (id.x >= (1 + (_buffer_sizes.size2 - 0 - 12) / 12)) {
        return;
    }
    uint _e8 = accumulation.samples_per_pixel;
    uint _e12 = accumulation.first_sample;
    uint begin = metal::max(id.x * _e8, _e12);
    uint _e19 = accumulation.samples_per_pixel;
    uint pixel_end = (id.x + 1u) * _e19;
    uint _e23 = accumulation.first_sample;
    uint _e26 = accumulation.sample_count;
    uint end = metal::min(pixel_end, _e23 + _e26);
    PackedVec3_ _e35 = accumulation.starts.inner[metal::min(id.x, 1u)];
    metal::float3 _e36 = vec3_load(_e35);
    sum = _e36;
    sample = begin;
    uint2 loop_bound = uint2(4294967295u);
    bool loop_init = true;
    while(true) {
        if (metal::all(loop_bound == uint2(0u))) { break; }
        loop_bound -= uint2(loop_bound.y == 0u, 1u);
        if (!loop_init) {
            uint _e54 = sample;
            sample = _e54 + 1u;
        }
        loop_init = false;
        uint _e39 = sample;
        if (_e39 < end) {
        } else {
            break;
        }
        {
            metal::float3 _e41 = sum;
            uint _e43 = sample;
            uint _e46 = accumulation.first_sample;
            PackedVec3_ _e50 = samples[_e43 - _e46].color;
            metal::float3 _e51 = vec3_load(_e50);
            sum = _e41 + _e51;
        }
    }
    if (end == pixel_end) {
        metal::float3 _e57 = sum;
        uint _e60 = accumulation.samples_per_pixel;
        sum = _e57 / metal::float3(static_cast<float>(_e60));
    }
    metal::float3 _e67 = sum;
    PackedVec3_ _e68 = vec3_store(_e67);
    means_of_pixels[id.x] = _e68;
    return;
}

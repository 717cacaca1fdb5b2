struct Ray {
    float3 origin;
    int _pad1_0;
    float3 direction;
    int _end_pad_0;
};

struct Root {
    bool some;
    float lambda;
};

struct Hit {
    float3 point_;
    int _pad1_0;
    float3 normal;
    bool front;
};

struct SphereRecord {
    float3 center_;
    float radius;
    float radius_squared;
    int _end_pad_0;
    int _end_pad_1;
    int _end_pad_2;
};

struct SphereView {
    float3 r_c;
    float c;
};

struct SphereQuadratic {
    float h;
    float discriminant;
};

struct CylinderRecord {
    float3 center_;
    int _pad1_0;
    float3 axis;
    int _pad2_0;
    float3 top;
    int _pad3_0;
    float3 bottom;
    float radius;
    float radius_squared;
    float half_height;
    int _end_pad_0;
    int _end_pad_1;
};

struct CylinderView {
    float3 r_c;
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
    float3 position;
    int _pad1_0;
    float3 origin;
    int _pad2_0;
    float3 delta_x;
    int _pad3_0;
    float3 delta_y;
    int _end_pad_0;
};

struct Background {
    float3 dark;
    int _pad1_0;
    float3 light;
    int _end_pad_0;
};

struct Material {
    float3 reflectance;
    float index;
    float extent;
    uint kind;
    int _end_pad_0;
    int _end_pad_1;
};

struct PackedVec3_ {
    float x;
    float y;
    float z;
};

struct PlacedSphere {
    PackedVec3_ center_;
    float radius;
    uint order;
    uint material;
};

struct PlacedCylinder {
    PackedVec3_ center_;
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
    int _pad1_0;
    int _pad1_1;
    int _pad1_2;
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
    PackedVec3_ point_;
    PackedVec3_ normal;
    PackedVec3_ light;
};

static const float SHORT_SQUARED = 0.0;
static const float SHORT_SCALE = 1.0;
static const float BELOW_ONE = 0.99999994;
static const float LEAST_SQUARED = 0.0;
static const float ERROR_UNDERFLOW = 0.0;
static const float ERROR_OVERFLOW = 3e38;
static const float SHORTEST_SQUARED = 0.0;
static const float LONGEST_SQUARED = 3e38;
static const float EXTENT_UNDERFLOW = 0.0;
static const float SPLITTER = 4097.0;
static const float SPLIT_LIMIT = 1e33;
static const float SPLIT_SCALE = 1.5258789e-5;
static const float SPLIT_UNSCALE = 65536.0;
static const float UNWRITTEN = -2.8735182e-16;
static const uint SIDE = 0u;
static const uint TOP = 1u;
static const uint BOTTOM = 2u;
static const uint MATTE = 0u;
static const uint METAL = 1u;
static const uint REFRACTIVE = 2u;
static const bool has_spheres = true;
static const bool has_cylinders = true;
static const bool has_matte = true;
static const bool has_metal = true;
static const bool has_refraction = true;
static const uint max_depth = 5u;

ByteAddressBuffer picture : register(t0);
ByteAddressBuffer spheres : register(t1);
ByteAddressBuffer cylinders : register(t2);
ByteAddressBuffer materials : register(t3);
static bool closest_hit_gave_up = (bool)0;
RWByteAddressBuffer ways : register(u5);

float vec3_dot(float3 a, float3 b)
{
    return (((a.x * b.x) + (a.y * b.y)) + (a.z * b.z));
}

float vec3_length(float3 v)
{
    const float _e1 = vec3_dot(v, v);
    return sqrt(_e1);
}

float3 vec3_unit(float3 v_1)
{
    const float _e1 = vec3_length(v_1);
    return (v_1 / (_e1).xxx);
}

float3 vec3_perpendicular_to(float3 v_2, float3 axis)
{
    const float _e2 = vec3_dot(v_2, axis);
    return (v_2 - (axis * _e2));
}

bool vec3_is_negligible(float3 v_3)
{
    return (((abs(v_3.x) < 1e-8) & (abs(v_3.y) < 1e-8)) & (abs(v_3.z) < 1e-8));
}

float3 ray_at(Ray ray_1, float lambda)
{
    return (ray_1.origin + (ray_1.direction * lambda));
}

bool in_range(float lambda_1)
{
    return (0.001 <= lambda_1);
}

Hit ConstructHit(float3 arg0, float3 arg1, bool arg2) {
    Hit ret = (Hit)0;
    ret.point_ = arg0;
    ret.normal = arg1;
    ret.front = arg2;
    return ret;
}

Hit hit_facing(float3 direction, float3 point_, float3 outward)
{
    const float _e3 = vec3_dot(direction, outward);
    bool front_1 = (_e3 < 0.0);
    const Hit hit_1 = ConstructHit(point_, (front_1 ? outward : -(outward)), front_1);
    return hit_1;
}

SphereRecord ConstructSphereRecord(float3 arg0, float arg1, float arg2) {
    SphereRecord ret = (SphereRecord)0;
    ret.center_ = arg0;
    ret.radius = arg1;
    ret.radius_squared = arg2;
    return ret;
}

SphereRecord sphere_new(float3 center_, float radius)
{
    const SphereRecord sphererecord = ConstructSphereRecord(center_, radius, (radius * radius));
    return sphererecord;
}

SphereView ConstructSphereView(float3 arg0, float arg1) {
    SphereView ret = (SphereView)0;
    ret.r_c = arg0;
    ret.c = arg1;
    return ret;
}

SphereView sphere_seen_from(SphereRecord sphere, float3 origin)
{
    float3 r_c = (sphere.center_ - origin);
    const float _e4 = vec3_dot(r_c, r_c);
    const SphereView sphereview = ConstructSphereView(r_c, (_e4 - sphere.radius_squared));
    return sphereview;
}

SphereQuadratic ConstructSphereQuadratic(float arg0, float arg1) {
    SphereQuadratic ret = (SphereQuadratic)0;
    ret.h = arg0;
    ret.discriminant = arg1;
    return ret;
}

SphereQuadratic sphere_quadratic(SphereView view, float3 direction_1, float a_1)
{
    const float _e4 = vec3_dot(direction_1, view.r_c);
    const SphereQuadratic spherequadratic = ConstructSphereQuadratic(_e4, ((_e4 * _e4) - (a_1 * view.c)));
    return spherequadratic;
}

Root ConstructRoot(bool arg0, float arg1) {
    Root ret = (Root)0;
    ret.some = arg0;
    ret.lambda = arg1;
    return ret;
}

Root sphere_first_root(float a_2, float h, float discriminant)
{
    float root = sqrt(discriminant);
    float near = ((h - root) / a_2);
    float far = ((h + root) / a_2);
    const bool _e8 = in_range(near);
    float lambda_6 = (_e8 ? near : far);
    const bool _e10 = in_range(lambda_6);
    const Root root_1 = ConstructRoot(_e10, lambda_6);
    return root_1;
}

float3 sphere_outward(SphereRecord sphere_1, float3 point_1)
{
    return ((point_1 - sphere_1.center_) / (sphere_1.radius).xxx);
}

Root sphere_intersect(SphereRecord sphere_2, Ray ray_2)
{
    const float _e4 = vec3_dot(ray_2.direction, ray_2.direction);
    const SphereView _e6 = sphere_seen_from(sphere_2, ray_2.origin);
    const SphereQuadratic _e8 = sphere_quadratic(_e6, ray_2.direction, _e4);
    const Root _e11 = sphere_first_root(_e4, _e8.h, _e8.discriminant);
    const Root root_2 = ConstructRoot((!((_e8.discriminant < 0.0)) & _e11.some), _e11.lambda);
    return root_2;
}

bool tie_later_cap_is_closer(float lambda_2, float closest)
{
    return (lambda_2 < closest);
}

int tie_rank(uint order, bool on_cap)
{
    return (on_cap ? asint(asuint(int(-1)) - asuint(int(order))) : int(order));
}

bool tie_is_closer(float lambda_3, int rank, float closest_1, int closest_rank)
{
    return ((lambda_3 < closest_1) | ((lambda_3 <= closest_1) & (rank >= closest_rank)));
}

CylinderRecord ConstructCylinderRecord(float3 arg0, float3 arg1, float3 arg2, float3 arg3, float arg4, float arg5, float arg6) {
    CylinderRecord ret = (CylinderRecord)0;
    ret.center_ = arg0;
    ret.axis = arg1;
    ret.top = arg2;
    ret.bottom = arg3;
    ret.radius = arg4;
    ret.radius_squared = arg5;
    ret.half_height = arg6;
    return ret;
}

CylinderRecord cylinder_with_unit_axis(float3 center_1, float radius_1, float3 axis_1, float half_height)
{
    float3 to_cap = (axis_1 * half_height);
    const CylinderRecord cylinderrecord = ConstructCylinderRecord(center_1, axis_1, (center_1 + to_cap), (center_1 - to_cap), radius_1, (radius_1 * radius_1), half_height);
    return cylinderrecord;
}

CylinderView ConstructCylinderView(float3 arg0, float arg1) {
    CylinderView ret = (CylinderView)0;
    ret.r_c = arg0;
    ret.c = arg1;
    return ret;
}

CylinderView cylinder_seen_from(CylinderRecord cylinder, float3 origin_1)
{
    const float3 _e5 = vec3_perpendicular_to((origin_1 - cylinder.center_), cylinder.axis);
    const float _e6 = vec3_dot(_e5, _e5);
    const CylinderView cylinderview = ConstructCylinderView(_e5, (_e6 - cylinder.radius_squared));
    return cylinderview;
}

CylinderQuadratic ConstructCylinderQuadratic(float arg0, float arg1, float arg2) {
    CylinderQuadratic ret = (CylinderQuadratic)0;
    ret.a = arg0;
    ret.h = arg1;
    ret.discriminant = arg2;
    return ret;
}

CylinderQuadratic cylinder_quadratic(CylinderRecord cylinder_1, CylinderView view_1, float3 along)
{
    const float3 _e4 = vec3_perpendicular_to(along, cylinder_1.axis);
    const float _e5 = vec3_dot(_e4, _e4);
    const float _e7 = vec3_dot(view_1.r_c, _e4);
    const CylinderQuadratic cylinderquadratic = ConstructCylinderQuadratic(_e5, _e7, ((_e7 * _e7) - (_e5 * view_1.c)));
    return cylinderquadratic;
}

bool cylinder_within_height(CylinderRecord cylinder_2, Ray ray_3, float lambda_4)
{
    const float3 _e3 = ray_at(ray_3, lambda_4);
    const float _e7 = vec3_dot((_e3 - cylinder_2.center_), cylinder_2.axis);
    return (abs(_e7) <= cylinder_2.half_height);
}

Root cylinder_side(CylinderRecord cylinder_3, Ray ray_4, CylinderQuadratic quadratic)
{
    float root_3 = sqrt(quadratic.discriminant);
    float near_1 = ((-(quadratic.h) - root_3) / quadratic.a);
    float far_1 = ((-(quadratic.h) + root_3) / quadratic.a);
    const bool _e15 = in_range(near_1);
    const bool _e16 = cylinder_within_height(cylinder_3, ray_4, near_1);
    bool near_counts = (_e15 & _e16);
    const bool _e18 = in_range(far_1);
    const bool _e19 = cylinder_within_height(cylinder_3, ray_4, far_1);
    bool far_counts = (_e18 & _e19);
    const Root root_4 = ConstructRoot((near_counts | far_counts), (near_counts ? near_1 : far_1));
    return root_4;
}

Root cylinder_cap(CylinderRecord cylinder_4, Ray ray_5, float3 center_2)
{
    const float _e5 = vec3_dot(ray_5.direction, cylinder_4.axis);
    const float _e9 = vec3_dot((center_2 - ray_5.origin), cylinder_4.axis);
    float lambda_7 = (_e9 / _e5);
    const float3 _e11 = ray_at(ray_5, lambda_7);
    const float _e13 = vec3_length((_e11 - center_2));
    bool on_disc = (_e13 <= cylinder_4.radius);
    const bool _e20 = in_range(lambda_7);
    const Root root_5 = ConstructRoot(((!((abs(_e5) < 1e-8)) & _e20) & on_disc), lambda_7);
    return root_5;
}

float3 cylinder_outward(CylinderRecord cylinder_5, uint part, float3 point_2)
{
    const float3 _e6 = vec3_perpendicular_to((point_2 - cylinder_5.center_), cylinder_5.axis);
    float3 cap = ((part == TOP) ? cylinder_5.axis : -(cylinder_5.axis));
    return ((part == SIDE) ? _e6 : cap);
}

CylinderRoot ConstructCylinderRoot(bool arg0, float arg1, uint arg2) {
    CylinderRoot ret = (CylinderRoot)0;
    ret.some = arg0;
    ret.lambda = arg1;
    ret.part = arg2;
    return ret;
}

CylinderRoot cylinder_closer(CylinderRoot closest_2, Root later, uint part_1)
{
    const bool _e8 = tie_later_cap_is_closer(later.lambda, closest_2.lambda);
    bool replaces = (later.some & (!(closest_2.some) | _e8));
    float lambda_8 = (replaces ? later.lambda : closest_2.lambda);
    const CylinderRoot cylinderroot = ConstructCylinderRoot((closest_2.some | later.some), lambda_8, (replaces ? part_1 : closest_2.part));
    return cylinderroot;
}

CylinderRoot cylinder_with_caps(CylinderRecord cylinder_6, Ray ray_6, Root side)
{
    const Root _e4 = cylinder_cap(cylinder_6, ray_6, cylinder_6.top);
    const Root _e6 = cylinder_cap(cylinder_6, ray_6, cylinder_6.bottom);
    const CylinderRoot _e12 = cylinder_closer(ConstructCylinderRoot(side.some, side.lambda, SIDE), _e4, TOP);
    const CylinderRoot _e14 = cylinder_closer(_e12, _e6, BOTTOM);
    const CylinderRoot cylinderroot_1 = _e14;
    return cylinderroot_1;
}

CylinderRoot cylinder_intersect(CylinderRecord cylinder_7, Ray ray_7)
{
    const CylinderView _e3 = cylinder_seen_from(cylinder_7, ray_7.origin);
    const CylinderQuadratic _e5 = cylinder_quadratic(cylinder_7, _e3, ray_7.direction);
    const Root _e6 = cylinder_side(cylinder_7, ray_7, _e5);
    bool some = (!((_e5.discriminant < 0.0)) & _e6.some);
    const CylinderRoot _e15 = cylinder_with_caps(cylinder_7, ray_7, ConstructRoot(some, _e6.lambda));
    const CylinderRoot cylinderroot_2 = _e15;
    return cylinderroot_2;
}

Ray ConstructRay(float3 arg0, float3 arg1) {
    Ray ret = (Ray)0;
    ret.origin = arg0;
    ret.direction = arg1;
    return ret;
}

Ray camera_ray(Camera camera, float row, float column, float2 offset)
{
    float x = offset.x;
    float y = offset.y;
    float3 window_point = ((camera.origin + (camera.delta_x * (column + x))) + (camera.delta_y * (row + y)));
    const Ray ray_14 = ConstructRay(camera.position, (window_point - camera.position));
    return ray_14;
}

float3 background_color(Background background, float3 direction_2)
{
    const float _e3 = vec3_length(direction_2);
    float m = (((direction_2.y / _e3) + 1.0) / 2.0);
    return ((background.light * (1.0 - m)) + (background.dark * m));
}

float3 scatter_matte(float3 normal, float3 vector_)
{
    float3 direction_8 = (normal + vector_);
    const bool _e3 = vec3_is_negligible(direction_8);
    return (_e3 ? normal : direction_8);
}

float3 scatter_reflect(float3 direction_3, float3 normal_1)
{
    const float _e2 = vec3_dot(direction_3, normal_1);
    return (direction_3 - (normal_1 * (_e2 * 2.0)));
}

float3 scatter_mirror(float3 direction_4, float3 normal_2)
{
    const float3 _e2 = scatter_reflect(direction_4, normal_2);
    const float3 _e3 = vec3_unit(_e2);
    return _e3;
}

float3 scatter_metal(float3 direction_5, float3 normal_3, float3 vector_1)
{
    const float3 _e3 = scatter_mirror(direction_5, normal_3);
    return (_e3 + vector_1);
}

float scatter_index_ratio(float index, bool front)
{
    return (front ? (1.0 / index) : index);
}

float3 scatter_refract(float3 direction_6, float3 normal_4, float ratio)
{
    const float3 _e4 = vec3_unit(direction_6);
    const float _e5 = vec3_dot(_e4, normal_4);
    float product = -(_e5);
    float cos_ = ((product < 1.0) ? product : 1.0);
    float sin_ = sqrt((1.0 - (cos_ * cos_)));
    const float3 _e12 = scatter_reflect(_e4, normal_4);
    float3 p = ((_e4 + (normal_4 * cos_)) * ratio);
    const float _e16 = vec3_dot(p, p);
    float3 refracted = (p - (normal_4 * sqrt(abs((1.0 - _e16)))));
    bool beyond = (1.0 < (ratio * sin_));
    return (beyond ? _e12 : refracted);
}

float3 vec3_load(PackedVec3_ v_4)
{
    return float3(v_4.x, v_4.y, v_4.z);
}

PackedVec3_ ConstructPackedVec3_(float arg0, float arg1, float arg2) {
    PackedVec3_ ret = (PackedVec3_)0;
    ret.x = arg0;
    ret.y = arg1;
    ret.z = arg2;
    return ret;
}

PackedVec3_ vec3_store(float3 v_5)
{
    const PackedVec3_ packedvec3_ = ConstructPackedVec3_(v_5.x, v_5.y, v_5.z);
    return packedvec3_;
}

SphereRecord sphere_load(PlacedSphere sphere_3)
{
    const float3 _e2 = vec3_load(sphere_3.center_);
    const SphereRecord _e4 = sphere_new(_e2, sphere_3.radius);
    const SphereRecord sphererecord_1 = _e4;
    return sphererecord_1;
}

CylinderRecord cylinder_load(PlacedCylinder cylinder_8)
{
    const float3 _e2 = vec3_load(cylinder_8.axis);
    const float3 _e4 = vec3_load(cylinder_8.center_);
    const CylinderRecord _e7 = cylinder_with_unit_axis(_e4, cylinder_8.radius, _e2, cylinder_8.half_height);
    const CylinderRecord cylinderrecord_1 = _e7;
    return cylinderrecord_1;
}

Material ConstructMaterial(float3 arg0, float arg1, float arg2, uint arg3) {
    Material ret = (Material)0;
    ret.reflectance = arg0;
    ret.index = arg1;
    ret.extent = arg2;
    ret.kind = arg3;
    return ret;
}

Material material_load(PackedMaterial material)
{
    const float3 _e2 = vec3_load(material.reflectance);
    const Material material_3 = ConstructMaterial(_e2, material.index, material.extent, material.kind);
    return material_3;
}

Camera ConstructCamera(float3 arg0, float3 arg1, float3 arg2, float3 arg3) {
    Camera ret = (Camera)0;
    ret.position = arg0;
    ret.origin = arg1;
    ret.delta_x = arg2;
    ret.delta_y = arg3;
    return ret;
}

Camera picture_camera()
{
    PackedVec3_ _e3 = ConstructPackedVec3_(asfloat(picture.Load(0+0+0)), asfloat(picture.Load(0+0+4)), asfloat(picture.Load(0+0+8)));
    const float3 _e4 = vec3_load(_e3);
    PackedVec3_ _e8 = ConstructPackedVec3_(asfloat(picture.Load(12+0+0)), asfloat(picture.Load(12+0+4)), asfloat(picture.Load(12+0+8)));
    const float3 _e9 = vec3_load(_e8);
    PackedVec3_ _e13 = ConstructPackedVec3_(asfloat(picture.Load(24+0+0)), asfloat(picture.Load(24+0+4)), asfloat(picture.Load(24+0+8)));
    const float3 _e14 = vec3_load(_e13);
    PackedVec3_ _e18 = ConstructPackedVec3_(asfloat(picture.Load(36+0+0)), asfloat(picture.Load(36+0+4)), asfloat(picture.Load(36+0+8)));
    const float3 _e19 = vec3_load(_e18);
    const Camera camera_1 = ConstructCamera(_e4, _e9, _e14, _e19);
    return camera_1;
}

Background ConstructBackground(float3 arg0, float3 arg1) {
    Background ret = (Background)0;
    ret.dark = arg0;
    ret.light = arg1;
    return ret;
}

Background picture_background()
{
    PackedVec3_ _e3 = ConstructPackedVec3_(asfloat(picture.Load(0+48+0)), asfloat(picture.Load(0+48+4)), asfloat(picture.Load(0+48+8)));
    const float3 _e4 = vec3_load(_e3);
    PackedVec3_ _e8 = ConstructPackedVec3_(asfloat(picture.Load(12+48+0)), asfloat(picture.Load(12+48+4)), asfloat(picture.Load(12+48+8)));
    const float3 _e9 = vec3_load(_e8);
    const Background background_1 = ConstructBackground(_e4, _e9);
    return background_1;
}

bool is_closer(ClosestHit closest_3, float lambda_5, uint order_1, uint part_2)
{
    const int _e8 = tie_rank(closest_3.order, (closest_3.part != SIDE));
    const int _e11 = tie_rank(order_1, (part_2 != SIDE));
    const bool _e15 = tie_is_closer(lambda_5, _e11, closest_3.lambda, _e8);
    return (!(closest_3.some) | _e15);
}

ClosestHit ConstructClosestHit(bool arg0, float arg1, uint arg2, bool arg3, uint arg4, uint arg5) {
    ClosestHit ret = (ClosestHit)0;
    ret.some = arg0;
    ret.lambda = arg1;
    ret.order = arg2;
    ret.is_cylinder = arg3;
    ret.index = arg4;
    ret.part = arg5;
    return ret;
}

PlacedSphere ConstructPlacedSphere(PackedVec3_ arg0, float arg1, uint arg2, uint arg3) {
    PlacedSphere ret = (PlacedSphere)0;
    ret.center_ = arg0;
    ret.radius = arg1;
    ret.order = arg2;
    ret.material = arg3;
    return ret;
}

ClosestHit intersect_sphere(ClosestHit closest_4, Ray ray_8, uint index_1)
{
    ClosestHit result = (ClosestHit)0;

    PlacedSphere placed = ConstructPlacedSphere(ConstructPackedVec3_(asfloat(spheres.Load(index_1*24+0+0)), asfloat(spheres.Load(index_1*24+0+4)), asfloat(spheres.Load(index_1*24+0+8))), asfloat(spheres.Load(index_1*24+12)), asuint(spheres.Load(index_1*24+16)), asuint(spheres.Load(index_1*24+20)));
    const SphereRecord _e6 = sphere_load(placed);
    const Root _e7 = sphere_intersect(_e6, ray_8);
    uint order_2 = placed.order;
    result = closest_4;
    const bool _e13 = is_closer(closest_4, _e7.lambda, order_2, SIDE);
    if ((_e7.some & _e13)) {
        result = ConstructClosestHit(true, _e7.lambda, order_2, false, index_1, SIDE);
    }
    ClosestHit _e20 = result;
    const ClosestHit closesthit = _e20;
    return closesthit;
}

PlacedCylinder ConstructPlacedCylinder(PackedVec3_ arg0, PackedVec3_ arg1, float arg2, float arg3, uint arg4, uint arg5) {
    PlacedCylinder ret = (PlacedCylinder)0;
    ret.center_ = arg0;
    ret.axis = arg1;
    ret.radius = arg2;
    ret.half_height = arg3;
    ret.order = arg4;
    ret.material = arg5;
    return ret;
}

ClosestHit intersect_cylinder(ClosestHit closest_5, Ray ray_9, uint index_2)
{
    ClosestHit result_1 = (ClosestHit)0;

    PlacedCylinder placed_1 = ConstructPlacedCylinder(ConstructPackedVec3_(asfloat(cylinders.Load(index_2*40+0+0)), asfloat(cylinders.Load(index_2*40+0+4)), asfloat(cylinders.Load(index_2*40+0+8))), ConstructPackedVec3_(asfloat(cylinders.Load(index_2*40+12+0)), asfloat(cylinders.Load(index_2*40+12+4)), asfloat(cylinders.Load(index_2*40+12+8))), asfloat(cylinders.Load(index_2*40+24)), asfloat(cylinders.Load(index_2*40+28)), asuint(cylinders.Load(index_2*40+32)), asuint(cylinders.Load(index_2*40+36)));
    const CylinderRecord _e6 = cylinder_load(placed_1);
    const CylinderRoot _e7 = cylinder_intersect(_e6, ray_9);
    uint order_3 = placed_1.order;
    result_1 = closest_5;
    const bool _e13 = is_closer(closest_5, _e7.lambda, order_3, _e7.part);
    if ((_e7.some & _e13)) {
        result_1 = ConstructClosestHit(true, _e7.lambda, order_3, true, index_2, _e7.part);
    }
    ClosestHit _e20 = result_1;
    const ClosestHit closesthit_1 = _e20;
    return closesthit_1;
}

SurfaceHit ConstructSurfaceHit(bool arg0, Hit arg1, uint arg2, float arg3, uint arg4, uint arg5) {
    SurfaceHit ret = (SurfaceHit)0;
    ret.some = arg0;
    ret.hit = arg1;
    ret.material = arg2;
    ret.lambda = arg3;
    ret.order = arg4;
    ret.part = arg5;
    return ret;
}

SurfaceHit surface_at(ClosestHit closest_6, Ray ray_10)
{
    float3 outward_1 = (float3)0;
    uint material_1 = (uint)0;
    bool local = (bool)0;
    bool local_1 = (bool)0;

    const float3 _e3 = ray_at(ray_10, closest_6.lambda);
    if (has_spheres) {
        local = !(closest_6.is_cylinder);
    } else {
        local = false;
    }
    bool _e12 = local;
    if (_e12) {
        PlacedSphere _e16 = ConstructPlacedSphere(ConstructPackedVec3_(asfloat(spheres.Load(closest_6.index*24+0+0)), asfloat(spheres.Load(closest_6.index*24+0+4)), asfloat(spheres.Load(closest_6.index*24+0+8))), asfloat(spheres.Load(closest_6.index*24+12)), asuint(spheres.Load(closest_6.index*24+16)), asuint(spheres.Load(closest_6.index*24+20)));
        const SphereRecord _e17 = sphere_load(_e16);
        const float3 _e18 = sphere_outward(_e17, _e3);
        outward_1 = _e18;
        uint _e23 = asuint(spheres.Load(20+closest_6.index*24));
        material_1 = _e23;
    }
    if (has_cylinders) {
        local_1 = closest_6.is_cylinder;
    } else {
        local_1 = false;
    }
    bool _e29 = local_1;
    if (_e29) {
        PlacedCylinder _e33 = ConstructPlacedCylinder(ConstructPackedVec3_(asfloat(cylinders.Load(closest_6.index*40+0+0)), asfloat(cylinders.Load(closest_6.index*40+0+4)), asfloat(cylinders.Load(closest_6.index*40+0+8))), ConstructPackedVec3_(asfloat(cylinders.Load(closest_6.index*40+12+0)), asfloat(cylinders.Load(closest_6.index*40+12+4)), asfloat(cylinders.Load(closest_6.index*40+12+8))), asfloat(cylinders.Load(closest_6.index*40+24)), asfloat(cylinders.Load(closest_6.index*40+28)), asuint(cylinders.Load(closest_6.index*40+32)), asuint(cylinders.Load(closest_6.index*40+36)));
        const CylinderRecord _e34 = cylinder_load(_e33);
        const float3 _e36 = cylinder_outward(_e34, closest_6.part, _e3);
        outward_1 = _e36;
        uint _e41 = asuint(cylinders.Load(36+closest_6.index*40));
        material_1 = _e41;
    }
    float3 _e43 = outward_1;
    const Hit _e44 = hit_facing(ray_10.direction, _e3, _e43);
    uint _e46 = material_1;
    const SurfaceHit surfacehit = ConstructSurfaceHit(closest_6.some, _e44, _e46, closest_6.lambda, closest_6.order, closest_6.part);
    return surfacehit;
}

ClosestHit intersect_every_object(Ray ray_11)
{
    ClosestHit closest_7 = (ClosestHit)0;
    uint index_3 = 0u;
    uint index_4 = 0u;

    if (has_spheres) {
        uint2 loop_bound = uint2(4294967295u, 4294967295u);
        bool loop_init = true;
        while(true) {
            if (all(loop_bound == uint2(0u, 0u))) { break; }
            loop_bound -= uint2(loop_bound.y == 0u, 1u);
            if (!loop_init) {
                uint _e14 = index_3;
                index_3 = (_e14 + 1u);
            }
            loop_init = false;
            uint _e5 = index_3;
            uint _e8 = asuint(picture.Load(104));
            if ((_e5 < _e8)) {
            } else {
                break;
            }
            {
                ClosestHit _e10 = closest_7;
                uint _e11 = index_3;
                const ClosestHit _e12 = intersect_sphere(_e10, ray_11, _e11);
                closest_7 = _e12;
            }
        }
    }
    if (has_cylinders) {
        uint2 loop_bound_1 = uint2(4294967295u, 4294967295u);
        bool loop_init_1 = true;
        while(true) {
            if (all(loop_bound_1 == uint2(0u, 0u))) { break; }
            loop_bound_1 -= uint2(loop_bound_1.y == 0u, 1u);
            if (!loop_init_1) {
                uint _e28 = index_4;
                index_4 = (_e28 + 1u);
            }
            loop_init_1 = false;
            uint _e19 = index_4;
            uint _e22 = asuint(picture.Load(108));
            if ((_e19 < _e22)) {
            } else {
                break;
            }
            {
                ClosestHit _e24 = closest_7;
                uint _e25 = index_4;
                const ClosestHit _e26 = intersect_cylinder(_e24, ray_11, _e25);
                closest_7 = _e26;
            }
        }
    }
    ClosestHit _e30 = closest_7;
    const ClosestHit closesthit_2 = _e30;
    return closesthit_2;
}

SurfaceHit closest_hit(Ray ray_12)
{
    const ClosestHit _e1 = intersect_every_object(ray_12);
    const SurfaceHit _e2 = surface_at(_e1, ray_12);
    const SurfaceHit surfacehit_1 = _e2;
    return surfacehit_1;
}

Ray bounce_ray(Ray ray_13, Hit hit, Material material_2, float3 scatter_vector)
{
    float3 direction_7 = (float3)0;
    bool local_2 = (bool)0;
    bool local_3 = (bool)0;
    bool local_4 = (bool)0;

    if (has_matte) {
        local_2 = (material_2.kind == MATTE);
    } else {
        local_2 = false;
    }
    bool _e12 = local_2;
    if (_e12) {
        const float3 _e14 = scatter_matte(hit.normal, scatter_vector);
        direction_7 = _e14;
    }
    if (has_metal) {
        local_3 = (material_2.kind == METAL);
    } else {
        local_3 = false;
    }
    bool _e22 = local_3;
    if (_e22) {
        const float3 _e25 = scatter_metal(ray_13.direction, hit.normal, scatter_vector);
        direction_7 = _e25;
    }
    if (has_refraction) {
        local_4 = (material_2.kind == REFRACTIVE);
    } else {
        local_4 = false;
    }
    bool _e33 = local_4;
    if (_e33) {
        const float _e36 = scatter_index_ratio(material_2.index, hit.front);
        const float3 _e39 = scatter_refract(ray_13.direction, hit.normal, _e36);
        direction_7 = _e39;
    }
    float3 _e41 = direction_7;
    const Ray ray_15 = ConstructRay(hit.point_, _e41);
    return ray_15;
}

uint naga_div(uint lhs, uint rhs) {
    return lhs / (rhs == 0u ? 1u : rhs);
}

uint naga_mod(uint lhs, uint rhs) {
    return lhs % (rhs == 0u ? 1u : rhs);
}

Step ZeroValueStep() {
    return (Step)0;
}

uint naga_f2u32(float value) {
    return uint(clamp(value, 0.0, 4294967000.0));
}

Step ConstructStep(float arg0, float arg1, float arg2, float arg3, float arg4, float arg5, PackedVec3_ arg6, PackedVec3_ arg7, PackedVec3_ arg8, PackedVec3_ arg9, PackedVec3_ arg10) {
    Step ret = (Step)0;
    ret.is_hit = arg0;
    ret.lambda = arg1;
    ret.object = arg2;
    ret.part = arg3;
    ret.front = arg4;
    ret.material = arg5;
    ret.origin = arg6;
    ret.direction = arg7;
    ret.point_ = arg8;
    ret.normal = arg9;
    ret.light = arg10;
    return ret;
}

PackedMaterial ConstructPackedMaterial(PackedVec3_ arg0, float arg1, float arg2, uint arg3, uint arg4) {
    PackedMaterial ret = (PackedMaterial)0;
    ret.reflectance = arg0;
    ret.index = arg1;
    ret.extent = arg2;
    ret.kind = arg3;
    ret.unused = arg4;
    return ret;
}

[numthreads(64, 1, 1)]
void steps(uint3 id : SV_DispatchThreadID)
{
    Ray ray = (Ray)0;
    bool ended = false;
    uint depth = (uint)0;
    Step step_ = (Step)0;

    uint _e4 = asuint(picture.Load(100));
    if ((id.x >= _e4)) {
        return;
    }
    uint _e8 = asuint(picture.Load(96));
    uint pixel = (_e8 + id.x);
    float _e13 = asfloat(picture.Load(72));
    float _e16 = asfloat(picture.Load(76));
    float2 offset_1 = float2(_e13, _e16);
    PackedVec3_ _e20 = ConstructPackedVec3_(asfloat(picture.Load(80+0)), asfloat(picture.Load(80+4)), asfloat(picture.Load(80+8)));
    const float3 _e21 = vec3_load(_e20);
    const Camera _e22 = picture_camera();
    uint _e25 = asuint(picture.Load(92));
    uint _e30 = asuint(picture.Load(92));
    const Ray _e33 = camera_ray(_e22, float(naga_div(pixel, _e25)), float(naga_mod(pixel, _e30)), offset_1);
    ray = _e33;
    uint _e39 = asuint(picture.Load(112));
    if ((_e39 > 0u)) {
        uint _e48 = asuint(picture.Load(112));
        Step last = ConstructStep(asfloat(ways.Load((((id.x * max_depth) + _e48) - 1u)*84+0)), asfloat(ways.Load((((id.x * max_depth) + _e48) - 1u)*84+4)), asfloat(ways.Load((((id.x * max_depth) + _e48) - 1u)*84+8)), asfloat(ways.Load((((id.x * max_depth) + _e48) - 1u)*84+12)), asfloat(ways.Load((((id.x * max_depth) + _e48) - 1u)*84+16)), asfloat(ways.Load((((id.x * max_depth) + _e48) - 1u)*84+20)), ConstructPackedVec3_(asfloat(ways.Load((((id.x * max_depth) + _e48) - 1u)*84+24+0)), asfloat(ways.Load((((id.x * max_depth) + _e48) - 1u)*84+24+4)), asfloat(ways.Load((((id.x * max_depth) + _e48) - 1u)*84+24+8))), ConstructPackedVec3_(asfloat(ways.Load((((id.x * max_depth) + _e48) - 1u)*84+36+0)), asfloat(ways.Load((((id.x * max_depth) + _e48) - 1u)*84+36+4)), asfloat(ways.Load((((id.x * max_depth) + _e48) - 1u)*84+36+8))), ConstructPackedVec3_(asfloat(ways.Load((((id.x * max_depth) + _e48) - 1u)*84+48+0)), asfloat(ways.Load((((id.x * max_depth) + _e48) - 1u)*84+48+4)), asfloat(ways.Load((((id.x * max_depth) + _e48) - 1u)*84+48+8))), ConstructPackedVec3_(asfloat(ways.Load((((id.x * max_depth) + _e48) - 1u)*84+60+0)), asfloat(ways.Load((((id.x * max_depth) + _e48) - 1u)*84+60+4)), asfloat(ways.Load((((id.x * max_depth) + _e48) - 1u)*84+60+8))), ConstructPackedVec3_(asfloat(ways.Load((((id.x * max_depth) + _e48) - 1u)*84+72+0)), asfloat(ways.Load((((id.x * max_depth) + _e48) - 1u)*84+72+4)), asfloat(ways.Load((((id.x * max_depth) + _e48) - 1u)*84+72+8))));
        ended = (last.is_hit != 1.0);
        const float3 _e58 = vec3_load(last.origin);
        const float3 _e60 = vec3_load(last.direction);
        ray = ConstructRay(_e58, _e60);
        bool _e62 = ended;
        if (!(_e62)) {
            const float3 _e65 = vec3_load(last.point_);
            const float3 _e67 = vec3_load(last.normal);
            Hit hit_2 = ConstructHit(_e65, _e67, (last.front == 1.0));
            Ray _e72 = ray;
            PackedMaterial _e77 = ConstructPackedMaterial(ConstructPackedVec3_(asfloat(materials.Load(naga_f2u32(last.material)*28+0+0)), asfloat(materials.Load(naga_f2u32(last.material)*28+0+4)), asfloat(materials.Load(naga_f2u32(last.material)*28+0+8))), asfloat(materials.Load(naga_f2u32(last.material)*28+12)), asfloat(materials.Load(naga_f2u32(last.material)*28+16)), asuint(materials.Load(naga_f2u32(last.material)*28+20)), asuint(materials.Load(naga_f2u32(last.material)*28+24)));
            const Material _e78 = material_load(_e77);
            const Ray _e79 = bounce_ray(_e72, hit_2, _e78, _e21);
            ray = _e79;
        }
    }
    uint _e82 = asuint(picture.Load(112));
    depth = _e82;
    uint2 loop_bound_2 = uint2(4294967295u, 4294967295u);
    bool loop_init_2 = true;
    while(true) {
        if (all(loop_bound_2 == uint2(0u, 0u))) { break; }
        loop_bound_2 -= uint2(loop_bound_2.y == 0u, 1u);
        if (!loop_init_2) {
            uint _e162 = depth;
            depth = (_e162 + 1u);
        }
        loop_init_2 = false;
        uint _e84 = depth;
        uint _e88 = asuint(picture.Load(116));
        if ((_e84 < min(max_depth, _e88))) {
        } else {
            break;
        }
        {
            step_ = ZeroValueStep();
            bool _e93 = ended;
            if (_e93) {
                step_.is_hit = -1.0;
            } else {
                float3 _e98 = ray.origin;
                const PackedVec3_ _e99 = vec3_store(_e98);
                step_.origin = _e99;
                float3 _e102 = ray.direction;
                const PackedVec3_ _e103 = vec3_store(_e102);
                step_.direction = _e103;
                Ray _e104 = ray;
                const SurfaceHit _e105 = closest_hit(_e104);
                if (_e105.some) {
                    step_.is_hit = 1.0;
                    step_.lambda = _e105.lambda;
                    step_.object = float(_e105.order);
                    step_.part = float(_e105.part);
                    step_.front = (_e105.hit.front ? 1.0 : 0.0);
                    step_.material = float(_e105.material);
                    const PackedVec3_ _e129 = vec3_store(_e105.hit.point_);
                    step_.point_ = _e129;
                    const PackedVec3_ _e133 = vec3_store(_e105.hit.normal);
                    step_.normal = _e133;
                    Ray _e134 = ray;
                    PackedMaterial _e139 = ConstructPackedMaterial(ConstructPackedVec3_(asfloat(materials.Load(_e105.material*28+0+0)), asfloat(materials.Load(_e105.material*28+0+4)), asfloat(materials.Load(_e105.material*28+0+8))), asfloat(materials.Load(_e105.material*28+12)), asfloat(materials.Load(_e105.material*28+16)), asuint(materials.Load(_e105.material*28+20)), asuint(materials.Load(_e105.material*28+24)));
                    const Material _e140 = material_load(_e139);
                    const Ray _e141 = bounce_ray(_e134, _e105.hit, _e140, _e21);
                    ray = _e141;
                } else {
                    const Background _e143 = picture_background();
                    float3 _e145 = ray.direction;
                    const float3 _e146 = background_color(_e143, _e145);
                    const PackedVec3_ _e147 = vec3_store(_e146);
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
            {
                Step _value4 = _e160;
                ways.Store(((id.x * max_depth) + _e157)*84+0, asuint(_value4.is_hit));
                ways.Store(((id.x * max_depth) + _e157)*84+4, asuint(_value4.lambda));
                ways.Store(((id.x * max_depth) + _e157)*84+8, asuint(_value4.object));
                ways.Store(((id.x * max_depth) + _e157)*84+12, asuint(_value4.part));
                ways.Store(((id.x * max_depth) + _e157)*84+16, asuint(_value4.front));
                ways.Store(((id.x * max_depth) + _e157)*84+20, asuint(_value4.material));
                {
                    PackedVec3_ _value5 = _value4.origin;
                    ways.Store(((id.x * max_depth) + _e157)*84+24+0, asuint(_value5.x));
                    ways.Store(((id.x * max_depth) + _e157)*84+24+4, asuint(_value5.y));
                    ways.Store(((id.x * max_depth) + _e157)*84+24+8, asuint(_value5.z));
                }
                {
                    PackedVec3_ _value5 = _value4.direction;
                    ways.Store(((id.x * max_depth) + _e157)*84+36+0, asuint(_value5.x));
                    ways.Store(((id.x * max_depth) + _e157)*84+36+4, asuint(_value5.y));
                    ways.Store(((id.x * max_depth) + _e157)*84+36+8, asuint(_value5.z));
                }
                {
                    PackedVec3_ _value5 = _value4.point_;
                    ways.Store(((id.x * max_depth) + _e157)*84+48+0, asuint(_value5.x));
                    ways.Store(((id.x * max_depth) + _e157)*84+48+4, asuint(_value5.y));
                    ways.Store(((id.x * max_depth) + _e157)*84+48+8, asuint(_value5.z));
                }
                {
                    PackedVec3_ _value5 = _value4.normal;
                    ways.Store(((id.x * max_depth) + _e157)*84+60+0, asuint(_value5.x));
                    ways.Store(((id.x * max_depth) + _e157)*84+60+4, asuint(_value5.y));
                    ways.Store(((id.x * max_depth) + _e157)*84+60+8, asuint(_value5.z));
                }
                {
                    PackedVec3_ _value5 = _value4.light;
                    ways.Store(((id.x * max_depth) + _e157)*84+72+0, asuint(_value5.x));
                    ways.Store(((id.x * max_depth) + _e157)*84+72+4, asuint(_value5.y));
                    ways.Store(((id.x * max_depth) + _e157)*84+72+8, asuint(_value5.z));
                }
            }
        }
    }
    return;
}

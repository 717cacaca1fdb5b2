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

struct PackedRay {
    PackedVec3_ origin;
    PackedVec3_ direction;
};

struct TracedSample {
    PackedVec3_ color;
    uint words;
    uint unused;
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

struct ScatterVector {
    float3 vector_;
    uint next_word;
};

struct PackedSamplePath {
    PackedRay ray;
    uint attenuation_count;
    uint ended;
    uint next_word;
    uint unused;
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
static const uint STATEMENT = 1u;
static const uint PUBLISHED = 2u;
static const uint MAX_TRIES = 100u;
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
RWByteAddressBuffer attenuations : register(u4);
ByteAddressBuffer words : register(t7);
RWByteAddressBuffer traced_samples : register(u5);
RWByteAddressBuffer sample_paths : register(u6);

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

float3 ray_at(Ray ray, float lambda)
{
    return (ray.origin + (ray.direction * lambda));
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

Root sphere_intersect(SphereRecord sphere_2, Ray ray_1)
{
    const float _e4 = vec3_dot(ray_1.direction, ray_1.direction);
    const SphereView _e6 = sphere_seen_from(sphere_2, ray_1.origin);
    const SphereQuadratic _e8 = sphere_quadratic(_e6, ray_1.direction, _e4);
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

bool cylinder_within_height(CylinderRecord cylinder_2, Ray ray_2, float lambda_4)
{
    const float3 _e3 = ray_at(ray_2, lambda_4);
    const float _e7 = vec3_dot((_e3 - cylinder_2.center_), cylinder_2.axis);
    return (abs(_e7) <= cylinder_2.half_height);
}

Root cylinder_side(CylinderRecord cylinder_3, Ray ray_3, CylinderQuadratic quadratic)
{
    float root_3 = sqrt(quadratic.discriminant);
    float near_1 = ((-(quadratic.h) - root_3) / quadratic.a);
    float far_1 = ((-(quadratic.h) + root_3) / quadratic.a);
    const bool _e15 = in_range(near_1);
    const bool _e16 = cylinder_within_height(cylinder_3, ray_3, near_1);
    bool near_counts = (_e15 & _e16);
    const bool _e18 = in_range(far_1);
    const bool _e19 = cylinder_within_height(cylinder_3, ray_3, far_1);
    bool far_counts = (_e18 & _e19);
    const Root root_4 = ConstructRoot((near_counts | far_counts), (near_counts ? near_1 : far_1));
    return root_4;
}

Root cylinder_cap(CylinderRecord cylinder_4, Ray ray_4, float3 center_2)
{
    const float _e5 = vec3_dot(ray_4.direction, cylinder_4.axis);
    const float _e9 = vec3_dot((center_2 - ray_4.origin), cylinder_4.axis);
    float lambda_7 = (_e9 / _e5);
    const float3 _e11 = ray_at(ray_4, lambda_7);
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

CylinderRoot cylinder_with_caps(CylinderRecord cylinder_6, Ray ray_5, Root side)
{
    const Root _e4 = cylinder_cap(cylinder_6, ray_5, cylinder_6.top);
    const Root _e6 = cylinder_cap(cylinder_6, ray_5, cylinder_6.bottom);
    const CylinderRoot _e12 = cylinder_closer(ConstructCylinderRoot(side.some, side.lambda, SIDE), _e4, TOP);
    const CylinderRoot _e14 = cylinder_closer(_e12, _e6, BOTTOM);
    const CylinderRoot cylinderroot_1 = _e14;
    return cylinderroot_1;
}

CylinderRoot cylinder_intersect(CylinderRecord cylinder_7, Ray ray_6)
{
    const CylinderView _e3 = cylinder_seen_from(cylinder_7, ray_6.origin);
    const CylinderQuadratic _e5 = cylinder_quadratic(cylinder_7, _e3, ray_6.direction);
    const Root _e6 = cylinder_side(cylinder_7, ray_6, _e5);
    bool some = (!((_e5.discriminant < 0.0)) & _e6.some);
    const CylinderRoot _e15 = cylinder_with_caps(cylinder_7, ray_6, ConstructRoot(some, _e6.lambda));
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
    const Ray ray_16 = ConstructRay(camera.position, (window_point - camera.position));
    return ray_16;
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

Ray ray_load(PackedRay ray_7)
{
    const float3 _e2 = vec3_load(ray_7.origin);
    const float3 _e4 = vec3_load(ray_7.direction);
    const Ray ray_17 = ConstructRay(_e2, _e4);
    return ray_17;
}

PackedRay ConstructPackedRay(PackedVec3_ arg0, PackedVec3_ arg1) {
    PackedRay ret = (PackedRay)0;
    ret.origin = arg0;
    ret.direction = arg1;
    return ret;
}

PackedRay ray_store(Ray ray_8)
{
    const PackedVec3_ _e2 = vec3_store(ray_8.origin);
    const PackedVec3_ _e4 = vec3_store(ray_8.direction);
    const PackedRay packedray = ConstructPackedRay(_e2, _e4);
    return packedray;
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
    const Material material_4 = ConstructMaterial(_e2, material.index, material.extent, material.kind);
    return material_4;
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

ClosestHit intersect_sphere(ClosestHit closest_4, Ray ray_9, uint index_1)
{
    ClosestHit result = (ClosestHit)0;

    PlacedSphere placed = ConstructPlacedSphere(ConstructPackedVec3_(asfloat(spheres.Load(index_1*24+0+0)), asfloat(spheres.Load(index_1*24+0+4)), asfloat(spheres.Load(index_1*24+0+8))), asfloat(spheres.Load(index_1*24+12)), asuint(spheres.Load(index_1*24+16)), asuint(spheres.Load(index_1*24+20)));
    const SphereRecord _e6 = sphere_load(placed);
    const Root _e7 = sphere_intersect(_e6, ray_9);
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

ClosestHit intersect_cylinder(ClosestHit closest_5, Ray ray_10, uint index_2)
{
    ClosestHit result_1 = (ClosestHit)0;

    PlacedCylinder placed_1 = ConstructPlacedCylinder(ConstructPackedVec3_(asfloat(cylinders.Load(index_2*40+0+0)), asfloat(cylinders.Load(index_2*40+0+4)), asfloat(cylinders.Load(index_2*40+0+8))), ConstructPackedVec3_(asfloat(cylinders.Load(index_2*40+12+0)), asfloat(cylinders.Load(index_2*40+12+4)), asfloat(cylinders.Load(index_2*40+12+8))), asfloat(cylinders.Load(index_2*40+24)), asfloat(cylinders.Load(index_2*40+28)), asuint(cylinders.Load(index_2*40+32)), asuint(cylinders.Load(index_2*40+36)));
    const CylinderRecord _e6 = cylinder_load(placed_1);
    const CylinderRoot _e7 = cylinder_intersect(_e6, ray_10);
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

SurfaceHit surface_at(ClosestHit closest_6, Ray ray_11)
{
    float3 outward_1 = (float3)0;
    uint material_1 = (uint)0;
    bool local = (bool)0;
    bool local_1 = (bool)0;

    const float3 _e3 = ray_at(ray_11, closest_6.lambda);
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
    const Hit _e44 = hit_facing(ray_11.direction, _e3, _e43);
    uint _e46 = material_1;
    const SurfaceHit surfacehit = ConstructSurfaceHit(closest_6.some, _e44, _e46, closest_6.lambda, closest_6.order, closest_6.part);
    return surfacehit;
}

ClosestHit intersect_every_object(Ray ray_12)
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
                const ClosestHit _e12 = intersect_sphere(_e10, ray_12, _e11);
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
                const ClosestHit _e26 = intersect_cylinder(_e24, ray_12, _e25);
                closest_7 = _e26;
            }
        }
    }
    ClosestHit _e30 = closest_7;
    const ClosestHit closesthit_2 = _e30;
    return closesthit_2;
}

SurfaceHit closest_hit(Ray ray_13)
{
    const ClosestHit _e1 = intersect_every_object(ray_13);
    const SurfaceHit _e2 = surface_at(_e1, ray_13);
    const SurfaceHit surfacehit_1 = _e2;
    return surfacehit_1;
}

bool bounce_attenuates(Material material_2)
{
    bool local_2 = (bool)0;
    bool local_3 = (bool)0;
    bool local_4 = (bool)0;

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

Ray bounce_ray(Ray ray_14, Hit hit, Material material_3, float3 scatter_vector)
{
    float3 direction_7 = (float3)0;
    bool local_5 = (bool)0;
    bool local_6 = (bool)0;
    bool local_7 = (bool)0;

    if (has_matte) {
        local_5 = (material_3.kind == MATTE);
    } else {
        local_5 = false;
    }
    bool _e12 = local_5;
    if (_e12) {
        const float3 _e14 = scatter_matte(hit.normal, scatter_vector);
        direction_7 = _e14;
    }
    if (has_metal) {
        local_6 = (material_3.kind == METAL);
    } else {
        local_6 = false;
    }
    bool _e22 = local_6;
    if (_e22) {
        const float3 _e25 = scatter_metal(ray_14.direction, hit.normal, scatter_vector);
        direction_7 = _e25;
    }
    if (has_refraction) {
        local_7 = (material_3.kind == REFRACTIVE);
    } else {
        local_7 = false;
    }
    bool _e33 = local_7;
    if (_e33) {
        const float _e36 = scatter_index_ratio(material_3.index, hit.front);
        const float3 _e39 = scatter_refract(ray_14.direction, hit.normal, _e36);
        direction_7 = _e39;
    }
    float3 _e41 = direction_7;
    const Ray ray_18 = ConstructRay(hit.point_, _e41);
    return ray_18;
}

float3 bounce_attenuated(float3 color, uint first, uint attenuation_count)
{
    float3 attenuated = (float3)0;
    uint left = (uint)0;

    attenuated = color;
    left = attenuation_count;
    uint2 loop_bound_2 = uint2(4294967295u, 4294967295u);
    bool loop_init_2 = true;
    while(true) {
        if (all(loop_bound_2 == uint2(0u, 0u))) { break; }
        loop_bound_2 -= uint2(loop_bound_2.y == 0u, 1u);
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
            float3 _e8 = attenuated;
            uint _e11 = left;
            uint _e16 = asuint(attenuations.Load(((first + _e11) - 1u)*4));
            PackedVec3_ _e19 = ConstructPackedVec3_(asfloat(materials.Load(0+_e16*28+0)), asfloat(materials.Load(0+_e16*28+4)), asfloat(materials.Load(0+_e16*28+8)));
            const float3 _e20 = vec3_load(_e19);
            attenuated = (_e8 * _e20);
        }
    }
    float3 _e25 = attenuated;
    return _e25;
}

float uniform_canonical(uint2 word)
{
    float whole = ((float(word.y) * 4294967300.0) + float(word.x));
    float quotient = (whole / 1.8446744e19);
    return ((quotient < BELOW_ONE) ? quotient : BELOW_ONE);
}

float uniform_draw(uint2 word_1, float low, float high)
{
    const float _e3 = uniform_canonical(word_1);
    return ((_e3 * (high - low)) + low);
}

uint naga_mod(uint lhs, uint rhs) {
    return lhs % (rhs == 0u ? 1u : rhs);
}

uint NagaBufferLength(ByteAddressBuffer buffer)
{
    uint ret;
    buffer.GetDimensions(ret);
    return ret;
}

uint2 scatter_word(uint index_5)
{
    uint _e4 = asuint(picture.Load(120));
    uint first_1 = (3u * _e4);
    uint2 _e14 = asuint(words.Load2((first_1 + naga_mod((index_5 - first_1), (((NagaBufferLength(words) - 0) / 8) - first_1)))*8));
    return _e14;
}

float3 scatter_vector_in_cube(uint word_2, float half_)
{
    const uint2 _e2 = scatter_word(word_2);
    const float _e4 = uniform_draw(_e2, -(half_), half_);
    const uint2 _e7 = scatter_word((word_2 + 1u));
    const float _e9 = uniform_draw(_e7, -(half_), half_);
    const uint2 _e12 = scatter_word((word_2 + 2u));
    const float _e14 = uniform_draw(_e12, -(half_), half_);
    return float3(_e4, _e9, _e14);
}

ScatterVector ConstructScatterVector(float3 arg0, uint arg1) {
    ScatterVector ret = (ScatterVector)0;
    ret.vector_ = arg0;
    ret.next_word = arg1;
    return ret;
}

float3 ZeroValuefloat3() {
    return (float3)0;
}

ScatterVector scatter_vector_published(uint word_3, float extent)
{
    uint next = (uint)0;
    uint tries = 0u;
    bool local_8 = (bool)0;

    next = word_3;
    uint2 loop_bound_3 = uint2(4294967295u, 4294967295u);
    bool loop_init_3 = true;
    while(true) {
        if (all(loop_bound_3 == uint2(0u, 0u))) { break; }
        loop_bound_3 -= uint2(loop_bound_3.y == 0u, 1u);
        if (!loop_init_3) {
            uint _e30 = tries;
            tries = (_e30 + 1u);
        }
        loop_init_3 = false;
        uint _e5 = tries;
        if ((_e5 < MAX_TRIES)) {
        } else {
            break;
        }
        {
            uint _e8 = next;
            const float3 _e10 = scatter_vector_in_cube(_e8, 1.0);
            const float _e11 = vec3_dot(_e10, _e10);
            uint _e12 = next;
            next = (_e12 + 3u);
            if ((LEAST_SQUARED < _e11)) {
                local_8 = (_e11 <= 1.0);
            } else {
                local_8 = false;
            }
            bool _e22 = local_8;
            if (_e22) {
                uint _e27 = next;
                const ScatterVector scattervector = ConstructScatterVector(((_e10 / (sqrt(_e11)).xxx) * extent), _e27);
                return scattervector;
            }
        }
    }
    uint _e33 = next;
    const ScatterVector scattervector_1 = ConstructScatterVector(ZeroValuefloat3(), _e33);
    return scattervector_1;
}

ScatterVector scatter_vector_next(uint word_4, float extent_1)
{
    uint _e4 = asuint(picture.Load(132));
    if ((_e4 == STATEMENT)) {
        const float3 _e7 = scatter_vector_in_cube(word_4, extent_1);
        const ScatterVector scattervector_2 = ConstructScatterVector(_e7, (word_4 + 3u));
        return scattervector_2;
    }
    const ScatterVector _e11 = scatter_vector_published(word_4, extent_1);
    const ScatterVector scattervector_3 = _e11;
    return scattervector_3;
}

uint naga_div(uint lhs, uint rhs) {
    return lhs / (rhs == 0u ? 1u : rhs);
}

Ray sample_camera_ray(uint slot)
{
    uint _e3 = asuint(picture.Load(96));
    uint _e6 = asuint(picture.Load(124));
    uint _e10 = asuint(picture.Load(128));
    uint pixel = (_e3 + naga_div((_e6 + slot), _e10));
    uint2 _e18 = asuint(words.Load2((3u * slot)*8));
    const float _e20 = uniform_draw(_e18, -0.5, 0.5);
    uint2 _e27 = asuint(words.Load2(((3u * slot) + 1u)*8));
    const float _e29 = uniform_draw(_e27, -0.5, 0.5);
    uint _e32 = asuint(picture.Load(92));
    float row_1 = float(naga_div(pixel, _e32));
    uint _e37 = asuint(picture.Load(92));
    float column_1 = float(naga_mod(pixel, _e37));
    const Camera _e40 = picture_camera();
    const Ray _e42 = camera_ray(_e40, row_1, column_1, float2(_e20, _e29));
    const Ray ray_19 = _e42;
    return ray_19;
}

TracedSample ConstructTracedSample(PackedVec3_ arg0, uint arg1, uint arg2) {
    TracedSample ret = (TracedSample)0;
    ret.color = arg0;
    ret.words = arg1;
    ret.unused = arg2;
    return ret;
}

PackedSamplePath ConstructPackedSamplePath(PackedRay arg0, uint arg1, uint arg2, uint arg3, uint arg4) {
    PackedSamplePath ret = (PackedSamplePath)0;
    ret.ray = arg0;
    ret.attenuation_count = arg1;
    ret.ended = arg2;
    ret.next_word = arg3;
    ret.unused = arg4;
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

void trace_sample(uint slot_1)
{
    Ray ray_15 = (Ray)0;
    uint next_word = (uint)0;
    uint attenuation_count_1 = 0u;
    bool escapes = false;
    uint depth = (uint)0;
    float3 vector_2 = (float3)0;
    float3 color_1 = ZeroValuefloat3();

    uint first_word = asuint(words.Load(0+((3u * slot_1) + 2u)*8));
    uint first_2 = (slot_1 * max_depth);
    next_word = first_word;
    uint _e19 = asuint(picture.Load(112));
    if ((_e19 > 0u)) {
        uint _e25 = asuint(sample_paths.Load(28+slot_1*40));
        if ((_e25 != 0u)) {
            return;
        }
        PackedRay _e31 = ConstructPackedRay(ConstructPackedVec3_(asfloat(sample_paths.Load(0+slot_1*40+0+0)), asfloat(sample_paths.Load(0+slot_1*40+0+4)), asfloat(sample_paths.Load(0+slot_1*40+0+8))), ConstructPackedVec3_(asfloat(sample_paths.Load(0+slot_1*40+12+0)), asfloat(sample_paths.Load(0+slot_1*40+12+4)), asfloat(sample_paths.Load(0+slot_1*40+12+8))));
        const Ray _e32 = ray_load(_e31);
        ray_15 = _e32;
        uint _e36 = asuint(sample_paths.Load(32+slot_1*40));
        next_word = _e36;
        uint _e40 = asuint(sample_paths.Load(24+slot_1*40));
        attenuation_count_1 = _e40;
    } else {
        const Ray _e41 = sample_camera_ray(slot_1);
        ray_15 = _e41;
    }
    uint _e44 = asuint(picture.Load(112));
    depth = _e44;
    uint2 loop_bound_4 = uint2(4294967295u, 4294967295u);
    bool loop_init_4 = true;
    while(true) {
        if (all(loop_bound_4 == uint2(0u, 0u))) { break; }
        loop_bound_4 -= uint2(loop_bound_4.y == 0u, 1u);
        if (!loop_init_4) {
            uint _e84 = depth;
            depth = (_e84 + 1u);
        }
        loop_init_4 = false;
        uint _e46 = depth;
        uint _e50 = asuint(picture.Load(116));
        if ((_e46 < min(max_depth, _e50))) {
        } else {
            break;
        }
        {
            Ray _e53 = ray_15;
            const SurfaceHit _e54 = closest_hit(_e53);
            if (!(_e54.some)) {
                escapes = true;
                break;
            }
            PackedMaterial _e61 = ConstructPackedMaterial(ConstructPackedVec3_(asfloat(materials.Load(_e54.material*28+0+0)), asfloat(materials.Load(_e54.material*28+0+4)), asfloat(materials.Load(_e54.material*28+0+8))), asfloat(materials.Load(_e54.material*28+12)), asfloat(materials.Load(_e54.material*28+16)), asuint(materials.Load(_e54.material*28+20)), asuint(materials.Load(_e54.material*28+24)));
            const Material _e62 = material_load(_e61);
            vector_2 = ZeroValuefloat3();
            const bool _e65 = bounce_attenuates(_e62);
            if (_e65) {
                uint _e67 = attenuation_count_1;
                attenuations.Store((first_2 + _e67)*4, asuint(_e54.material));
                uint _e72 = attenuation_count_1;
                attenuation_count_1 = (_e72 + 1u);
                uint _e74 = next_word;
                const ScatterVector _e76 = scatter_vector_next(_e74, _e62.extent);
                vector_2 = _e76.vector_;
                next_word = _e76.next_word;
            }
            Ray _e79 = ray_15;
            float3 _e81 = vector_2;
            const Ray _e82 = bounce_ray(_e79, _e54.hit, _e62, _e81);
            ray_15 = _e82;
        }
    }
    bool _e88 = escapes;
    if (_e88) {
        const Background _e89 = picture_background();
        float3 _e91 = ray_15.direction;
        const float3 _e92 = background_color(_e89, _e91);
        uint _e93 = attenuation_count_1;
        const float3 _e94 = bounce_attenuated(_e92, first_2, _e93);
        color_1 = _e94;
    }
    float3 _e97 = color_1;
    const PackedVec3_ _e98 = vec3_store(_e97);
    uint _e99 = next_word;
    {
        TracedSample _value2 = ConstructTracedSample(_e98, (_e99 - first_word), 0u);
        {
            PackedVec3_ _value3 = _value2.color;
            traced_samples.Store(slot_1*20+0+0, asuint(_value3.x));
            traced_samples.Store(slot_1*20+0+4, asuint(_value3.y));
            traced_samples.Store(slot_1*20+0+8, asuint(_value3.z));
        }
        traced_samples.Store(slot_1*20+12, asuint(_value2.words));
        traced_samples.Store(slot_1*20+16, asuint(_value2.unused));
    }
    Ray _e105 = ray_15;
    const PackedRay _e106 = ray_store(_e105);
    uint _e107 = attenuation_count_1;
    bool _e110 = escapes;
    uint _e112 = next_word;
    {
        PackedSamplePath _value2 = ConstructPackedSamplePath(_e106, _e107, (_e110 ? 1u : 0u), _e112, 0u);
        {
            PackedRay _value3 = _value2.ray;
            {
                PackedVec3_ _value4 = _value3.origin;
                sample_paths.Store(slot_1*40+0+0+0, asuint(_value4.x));
                sample_paths.Store(slot_1*40+0+0+4, asuint(_value4.y));
                sample_paths.Store(slot_1*40+0+0+8, asuint(_value4.z));
            }
            {
                PackedVec3_ _value4 = _value3.direction;
                sample_paths.Store(slot_1*40+0+12+0, asuint(_value4.x));
                sample_paths.Store(slot_1*40+0+12+4, asuint(_value4.y));
                sample_paths.Store(slot_1*40+0+12+8, asuint(_value4.z));
            }
        }
        sample_paths.Store(slot_1*40+24, asuint(_value2.attenuation_count));
        sample_paths.Store(slot_1*40+28, asuint(_value2.ended));
        sample_paths.Store(slot_1*40+32, asuint(_value2.next_word));
        sample_paths.Store(slot_1*40+36, asuint(_value2.unused));
    }
    return;
}

[numthreads(64, 1, 1)]
void samples(uint3 id : SV_DispatchThreadID)
{
    uint _e4 = asuint(picture.Load(120));
    if ((id.x >= _e4)) {
        return;
    }
    trace_sample(id.x);
    bool _e8 = closest_hit_gave_up;
    if (_e8) {
        const PackedVec3_ _e15 = vec3_store((-2.8735182e-16).xxx);
        {
            PackedVec3_ _value3 = _e15;
            traced_samples.Store(0+id.x*20+0, asuint(_value3.x));
            traced_samples.Store(0+id.x*20+4, asuint(_value3.y));
            traced_samples.Store(0+id.x*20+8, asuint(_value3.z));
        }
        sample_paths.Store(28+id.x*40, asuint(1u));
        return;
    } else {
        return;
    }
}

// A student's program: the statement in C++, with mistakes that the environment variable MISTAKES names, separated by
// commas. The tests compile it and diagnose it. It shares nothing with the literal renderer in Rust.
//
//     g++ -std=c++20 -O2 cli/literal/tests/student.cpp -o student
//     MISTAKES=half_twice,no_caps ./student CONFIG SCENE OUT.ppm
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <fstream>
#include <map>
#include <optional>
#include <random>
#include <set>
#include <sstream>
#include <string>
#include <vector>

static std::set<std::string> mistakes;
static bool on(const char* name) { return mistakes.count(name) > 0; }

struct V { double x = 0, y = 0, z = 0; };
static V operator+(V a, V b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
static V operator-(V a, V b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
static V operator*(double s, V a) { return {a.x * s, a.y * s, a.z * s}; }
static V operator*(V a, V b) { return {a.x * b.x, a.y * b.y, a.z * b.z}; }
static V operator/(V a, double s) { return {a.x / s, a.y / s, a.z / s}; }
static double dot(V a, V b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
static V cross(V a, V b) { return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x}; }
static double norm(V a) { return std::sqrt(dot(a, a)); }
static V unit(V a) { return a / norm(a); }

struct Material { char kind; V reflectance{1, 1, 1}; double number = 0; };
struct Object { bool cylinder; V center; double radius; V axis; int material; };
struct Hit { double lambda; V point, normal; bool front; int material; bool base; };

static double gamma_ = 2.2, fov = 90;
static int width = 1920, aspect_w = 16, aspect_h = 9, samples = 20, depth = 5;
static V position{0, 0, -10}, target, north{0, 1, 0}, dark{.25, .5, 1}, light{1, 1, 1};
static std::uint64_t material_seed = 13, ray_seed = 19;
static std::vector<Material> materials;
static std::vector<Object> objects;

// One of two generators, chosen when it is seeded.
struct Random {
  std::mt19937_64 wide; std::mt19937 narrow; std::default_random_engine standard;
  void seed(std::uint64_t s) { wide.seed(s); narrow.seed(static_cast<std::uint32_t>(s)); standard.seed(static_cast<unsigned>(s)); }
  double draw(double lo, double hi) {
    std::uniform_real_distribution<double> d(lo, hi);
    if (on("mt32")) return d(narrow);
    if (on("default_engine")) return d(standard);
    return d(wide);
  }
};
static Random ray_random, material_random;

static double limit() {
  if (on("limit_1e-4")) return 1e-4;
  if (on("limit_1e-8")) return 1e-8;
  if (on("limit_0")) return 0;
  return 1e-3;
}
static bool counts(double lambda) { return on("limit_0") ? lambda > 0 : lambda >= limit(); }

static V random_vector(double extent) {
  auto draw = [&](double e) {
    if (on("zyx")) { double z = material_random.draw(-e, e), y = material_random.draw(-e, e), x = material_random.draw(-e, e); return V{x, y, z}; }
    double x = material_random.draw(-e, e);
    double y = material_random.draw(-e, e);
    double z = material_random.draw(-e, e);
    return V{x, y, z};
  };
  if (on("unit_vectors") || on("ball")) {
    for (;;) {
      V v = draw(1);
      double squared = dot(v, v);
      if (squared > 1 || squared < 1e-160) continue;
      return extent * (on("ball") ? v : v / std::sqrt(squared));
    }
  }
  if (on("cube_normalised")) return extent * unit(draw(1));
  return draw(extent);
}

static void consider(std::optional<Hit>& best, const Hit& hit) {
  if (!best || hit.lambda < best->lambda || (hit.lambda == best->lambda && !hit.base && !on("tie_first"))) best = hit;
}

static std::optional<Hit> hit_sphere(const Object& s, V o, V d) {
  V rc = s.center - o;
  double a = dot(d, d), b = (on("sign_of_b") ? 2 : -2) * dot(d, rc);
  double c = dot(rc, rc) - (on("radius_not_squared") ? s.radius : s.radius * s.radius);
  double delta = b * b - 4 * a * c;
  if (delta < 0) return {};
  double root = std::sqrt(delta), near = (-b - root) / (2 * a), far = (-b + root) / (2 * a);
  double lambda = on("far_root") ? far : near;
  if (!counts(lambda) && !on("first_root")) lambda = far;
  if (!counts(lambda)) return {};
  V point = o + lambda * d;
  V normal = on("normal_not_divided") ? point - s.center : (point - s.center) / s.radius;
  if (on("normal_inward")) normal = V{} - normal;
  return Hit{lambda, point, normal, true, s.material, false};
}

static std::optional<Hit> hit_cylinder(const Object& s, V o, V d) {
  double h = norm(s.axis);
  V a = on("axis_not_unit") ? s.axis : s.axis / h, center = s.center;
  double half = h / 2;
  if (on("height_double")) half = h;
  if (on("height_half")) half = h / 4;
  if (on("center_is_base")) center = s.center + (h / 2) * (s.axis / h);
  std::optional<Hit> best;
  V rc = o - center, rp = rc - dot(rc, a) * a, dp = d - dot(d, a) * a;
  double A = dot(dp, dp), B = 2 * dot(rp, dp), C = dot(rp, rp) - s.radius * s.radius, delta = B * B - 4 * A * C;
  if (delta >= 0 && !on("no_side")) {
    for (double lambda : {(-B - std::sqrt(delta)) / (2 * A), (-B + std::sqrt(delta)) / (2 * A)}) {
      V point = o + lambda * d;
      double along = dot(point - center, a);
      if (counts(lambda) && (std::abs(along) <= half || on("endless_side"))) {
        V normal = (point - center) - along * a;
        if (on("side_unit")) normal = unit(normal);
        best = Hit{lambda, point, normal, true, s.material, false};
        break;
      }
      if (on("first_root")) break;
    }
  }
  for (double sign : {1.0, -1.0}) {
    if (on("no_caps") || (on("no_lower_cap") && sign < 0)) continue;
    V n = sign * a, base = center + half * n;
    double slope = dot(d, n);
    if (std::abs(slope) < 1e-8) continue;
    double lambda = dot(base - o, n) / slope;
    V point = o + lambda * d;
    if (!counts(lambda) || (norm(point - base) > s.radius && !on("endless_caps"))) continue;
    if (best && lambda >= best->lambda) continue;
    best = Hit{lambda, point, on("cap_not_turned") ? a : n, true, s.material, true};
  }
  return best;
}

static std::optional<Hit> nearest(V o, V d) {
  std::optional<Hit> best;
  for (const Object& object : objects) {
    auto hit = object.cylinder ? hit_cylinder(object, o, d) : hit_sphere(object, o, d);
    if (!hit) continue;
    if (on("last_object")) best = hit; else consider(best, *hit);
  }
  if (best) {
    best->front = dot(d, best->normal) < 0;
    if (!best->front && !on("no_flip")) best->normal = V{} - best->normal;
  }
  return best;
}

static V background(V d) {
  double y = on("background_not_unit") ? d.y : unit(d).y, m = (y + 1) / 2;
  if (on("background_x")) m = (unit(d).x + 1) / 2;
  return on("background_swapped") ? (1 - m) * dark + m * light : (1 - m) * light + m * dark;
}

static V color(V o, V d, int left) {
  if (left <= 0) return on("end_background") ? background(d) : V{};
  auto hit = nearest(o, d);
  if (!hit) return background(d);
  if (left == 1 && on("no_last_draws")) return V{};
  const Material& m = materials[hit->material];
  V n = hit->normal, r;
  if (m.kind == 'm') {
    r = n + random_vector(1);
    if (std::abs(r.x) < 1e-8 && std::abs(r.y) < 1e-8 && std::abs(r.z) < 1e-8) r = n;
  } else if (m.kind == 'M') {
    V mirrored = d - (2 * dot(d, n)) * n;
    if (!on("metal_not_unit") && !on("metal_unit_after")) mirrored = unit(mirrored);
    if (on("smooth_without_draws") && m.number == 0) r = mirrored;
    else r = mirrored + random_vector(on("clamp_diffusion") ? std::min(1.0, m.number) : m.number);
    if (on("no_diffusion")) r = mirrored;
    if (on("metal_unit_after")) r = unit(r);
    if (on("absorb") && dot(r, n) <= 0) return V{};
  } else {
    V u = on("refract_not_unit") ? d : unit(d);
    double cosine = std::min(-dot(u, n), 1.0), sine = std::sqrt(1 - cosine * cosine);
    double ratio = hit->front ? 1 / m.number : m.number;
    if (on("rho_swapped")) ratio = 1 / ratio;
    if (on("rho_never")) ratio = m.number;
    bool reflects = ratio * sine > 1 && !on("no_total_reflection");
    if (on("schlick") && !reflects) {
      double r0 = (1 - ratio) / (1 + ratio); r0 = r0 * r0;
      reflects = r0 + (1 - r0) * std::pow(1 - cosine, 5) > material_random.draw(0, 1);
    }
    if (reflects) r = u - (2 * dot(u, n)) * n;
    else { V p = ratio * (u + cosine * n); r = p - std::sqrt(std::abs(1 - dot(p, p))) * n; }
  }
  V start = hit->point;
  if (on("bias_1e-3")) start = start + 1e-3 * n;
  if (on("bias_1e-4")) start = start + 1e-4 * n;
  if (on("bias_direction")) start = start + 1e-4 * r;
  V reflected = color(start, r, left - 1);
  if (on("no_reflectance")) return reflected;
  if (on("reflectance_squared")) return m.reflectance * m.reflectance * reflected;
  return m.reflectance * reflected;
}

static int byte(double mean) {
  double power = on("no_gamma") || on("gamma_first") ? mean : std::pow(mean, on("gamma_inverted") ? gamma_ : 1 / gamma_);
  double scaled = (on("scale_256") ? 256 : on("scale_254") ? 254 : 255) * power;
  if (on("rounded")) scaled = std::round(scaled);
  return std::isnan(scaled) ? 0 : static_cast<int>(std::clamp(scaled, 0.0, 255.0));
}

int main(int argc, char** argv) {
  if (const char* text = std::getenv("MISTAKES")) {
    std::istringstream in(text);
    for (std::string name; std::getline(in, name, ',');) mistakes.insert(name);
  }
  if (argc != 4) return 1;
  if (on("files_swapped")) std::swap(argv[1], argv[2]);
  if (on("default_gamma")) gamma_ = 2;
  if (on("default_depth")) depth = 10;
  std::ifstream config(argv[1]), scene(argv[2]);
  for (std::string line, key; std::getline(config, line);) {
    std::istringstream in(line);
    if (!(in >> key)) continue;
    auto vector = [&](V& v) { in >> v.x >> v.y >> v.z; };
    if (key == "image_width:") in >> width;
    else if (key == "aspect_ratio:") in >> aspect_w >> aspect_h;
    else if (key == "gamma:") in >> gamma_;
    else if (key == "camera_position:") vector(position);
    else if (key == "camera_target:") vector(target);
    else if (key == "camera_north:") { V n; vector(n); if (!on("north_ignored")) north = n; }
    else if (key == "field_of_view:") in >> fov;
    else if (key == "samples_per_pixel:") in >> samples;
    else if (key == "max_depth:") in >> depth;
    else if (key == "material_rng_seed:") in >> material_seed;
    else if (key == "ray_rng_seed:") in >> ray_seed;
    else if (key == "background_dark_color:") vector(dark);
    else if (key == "background_light_color:") vector(light);
    else return 1;
  }
  std::map<std::string, int> names;
  for (std::string line, key, name; std::getline(scene, line);) {
    std::istringstream in(line);
    if (!(in >> key)) continue;
    if (key == "sphere:" || key == "cylinder:") {
      Object o{key == "cylinder:", {}, 0, {}, 0};
      in >> o.center.x >> o.center.y >> o.center.z >> o.radius;
      if (o.cylinder) in >> o.axis.x >> o.axis.y >> o.axis.z;
      in >> name; o.material = names[name]; objects.push_back(o);
    } else {
      Material m{key == "matte:" ? 'm' : key == "metal:" ? 'M' : 'r'};
      in >> name;
      if (m.kind != 'r') in >> m.reflectance.x >> m.reflectance.y >> m.reflectance.z;
      if (m.kind != 'm') in >> m.number;
      names[name] = static_cast<int>(materials.size()); materials.push_back(m);
    }
  }
  if (on("seeds_swapped")) std::swap(ray_seed, material_seed);
  if (on("unseeded")) ray_seed = material_seed = 5489;
  if (on("clock")) ray_seed = std::random_device{}();
  auto reseed = [&](std::uint64_t number) { ray_random.seed(ray_seed + number); material_random.seed(material_seed + number); };
  reseed(0);
  double exact = width / (static_cast<double>(aspect_w) / aspect_h);
  if (on("aspect_integers")) exact = width / (aspect_w / aspect_h);
  int height = std::max(1, static_cast<int>(on("height_up") ? std::ceil(exact) : on("height_nearest") ? std::round(exact) : exact));
  V vf = position - target;
  double degrees = on("fov_degrees") ? 1 : M_PI / 180;
  double angle = on("fov_degrees") ? fov : fov * M_PI / 180; (void)degrees;
  double hp = 2 * std::tan(on("fov_not_halved") ? angle : angle / 2) * norm(vf);
  double wp = hp * (on("aspect_pair") ? static_cast<double>(aspect_w) / aspect_h : static_cast<double>(width) / height);
  V back = on("vf_not_unit") ? vf : unit(vf), u = cross(north, back);
  if (!on("u_not_unit")) u = unit(u);
  V v = cross(back, u), ph = wp * u, pv = (on("pv_positive") ? hp : -hp) * v;
  V dx = ph / (on("pixels_less_one") ? width - 1 : width), dy = pv / (on("pixels_less_one") ? height - 1 : height);
  V origin = position - vf - 0.5 * (ph + pv);
  if (!on("origin_without_half")) origin = origin + 0.5 * (dx + dy);
  if (on("printed_q")) origin = position;

  std::vector<V> sums(static_cast<std::size_t>(width) * height);
  auto sample = [&](int row, int column, int number) {
    int index = row * width + column;
    if (on("seed_per_row") && column == 0 && number == 0) reseed(0);
    if (on("seed_plus_row") && column == 0 && number == 0) reseed(row);
    if (on("seed_per_pixel") && number == 0) reseed(0);
    if (on("seed_plus_pixel") && number == 0) reseed(index);
    if (on("seed_per_sample")) reseed(0);
    if (on("threads") && column == 0 && number == 0 && row % ((height + 3) / 4) == 0) reseed(0);
    Random& random = on("one_generator") ? material_random : ray_random;
    double x = 0, y = 0, lo = on("offset_0_to_1") ? 0 : -.5, hi = on("offset_0_to_1") ? 1 : .5;
    if (on("y_before_x")) { y = random.draw(lo, hi); x = random.draw(lo, hi); }
    else if (!on("no_offset")) { x = random.draw(lo, hi); y = random.draw(lo, hi); }
    double half = on("half_twice") ? .5 : 0;
    V q = origin + (column + half + x) * dx + (row + half + y) * dy;
    V d = q - position;
    if (on("directions_unit")) d = unit(d);
    int rays = depth + (on("depth_more") ? 1 : 0) - (on("depth_less") ? 1 : 0);
    V c = color(position, d, rays);
    if (on("gamma_first")) c = {std::pow(c.x, 1 / gamma_), std::pow(c.y, 1 / gamma_), std::pow(c.z, 1 / gamma_)};
    sums[index] = sums[index] + c;
  };
  if (on("columns_first")) {
    for (int c = 0; c < width; c++) for (int r = 0; r < height; r++) for (int s = 0; s < samples; s++) sample(r, c, s);
  } else if (on("rows_upwards")) {
    for (int r = height; r-- > 0;) for (int c = 0; c < width; c++) for (int s = 0; s < samples; s++) sample(r, c, s);
  } else if (on("samples_outermost")) {
    for (int s = 0; s < samples; s++) for (int r = 0; r < height; r++) for (int c = 0; c < width; c++) sample(r, c, s);
  } else {
    for (int r = 0; r < height; r++) for (int c = 0; c < width; c++) for (int s = 0; s < samples; s++) sample(r, c, s);
  }
  std::ofstream out(argv[3]);
  out << "P3\n" << width << " " << height << "\n255\n";
  for (int r = 0; r < height; r++) for (int c = 0; c < width; c++) {
    int row = on("upside_down") ? height - 1 - r : r, column = on("mirrored") ? width - 1 - c : c;
    V mean = sums[static_cast<std::size_t>(row) * width + column] / samples;
    if (on("bgr")) std::swap(mean.x, mean.z);
    out << byte(mean.x) << " " << byte(mean.y) << " " << byte(mean.z) << "\n";
  }
}

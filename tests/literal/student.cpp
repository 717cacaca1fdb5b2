// A student's program: the statement in C++ in its simplest form, with the deviations that the environment variable
// MISTAKES names, separated by commas. The tests compile, diagnose, check and grade it. It shares nothing with the
// other renderers of this project.
//
//     g++ -std=c++20 -O2 -ffp-contract=off -pthread tests/literal/student.cpp -o student
//     MISTAKES=half_twice,no_caps ./student CONFIG SCENE OUT.ppm
// From GCC 16 on the library draws other numbers without this.
#define _GLIBCXX_USE_OLD_GENERATE_CANONICAL 1
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <fstream>
#include <iostream>
#include <map>
#include <optional>
#include <random>
#include <set>
#include <sstream>
#include <string>
#include <thread>
#include <vector>

// All switches. The program refuses another name in MISTAKES.
#define SWITCHES(S) \
  /* the camera and its samples */ \
  S(aspect_integers) S(aspect_pair) S(directions_unit) S(fov_degrees) S(fov_not_halved) S(height_nearest) S(height_up) \
  S(half_twice) S(no_offset) S(north_ignored) S(offset_0_to_1) S(origin_without_half) S(pixels_less_one) \
  S(printed_q) S(pv_positive) S(u_not_unit) S(vf_not_unit) S(y_before_x) \
  /* random numbers and the order of pixels */ \
  S(columns_first) S(default_engine) S(mt32) S(one_generator) S(random_seed) S(rows_upwards) S(samples_outermost) \
  S(second_thread) S(seed_per_pixel) S(seed_per_row) S(seed_per_sample) S(seed_plus_pixel) S(seed_plus_row) \
  S(seeds_swapped) S(threads) S(unseeded) S(zyx) \
  /* rays */ \
  S(bias_1e_3) S(bias_1e_4) S(bias_direction) S(depth_less) S(depth_more) S(end_background) S(far_root) S(first_root) \
  S(half_b) S(last_object) S(limit_0) S(limit_1e_4) S(limit_1e_8) S(no_last_draws) S(rays_unit) S(tie_first) \
  /* spheres and cylinders */ \
  S(axis_not_unit) S(cap_not_turned) S(center_is_base) S(endless_caps) S(endless_side) S(height_double) \
  S(height_half) S(no_caps) S(no_flip) S(no_lower_cap) S(no_side) S(normal_inward) S(normal_not_divided) \
  S(radius_not_squared) S(side_unit) S(sign_of_b) \
  /* materials and the background */ \
  S(absorb) S(background_not_unit) S(background_swapped) S(background_x) S(ball) S(clamp_diffusion) \
  S(cube_normalised) S(glass_free) S(matte_alone) S(metal_not_unit) S(metal_unit_after) S(no_diffusion) \
  S(no_reflectance) S(no_total_reflection) S(reflectance_squared) S(refract_not_unit) S(rho_never) S(rho_swapped) \
  S(schlick) S(smooth_without_draws) S(unit_vectors) \
  /* bytes, and their places in the file */ \
  S(bgr) S(gamma_first) S(gamma_inverted) S(mirrored) S(no_gamma) S(rounded) S(scale_254) S(scale_255_999) \
  S(scale_256) S(upside_down) \
  /* the form of the file */ \
  S(blanks_at_line_ends) S(comment) S(crlf) S(header_on_one_line) S(no_last_line_end) S(number_a_line) \
  S(one_pixel_less) S(row_a_line) S(size_on_two_lines) S(tabs_between) S(two_blanks) \
  /* the default of one key */ \
  S(default_aspect) S(default_dark) S(default_depth) S(default_fov) S(default_gamma) S(default_light) \
  S(default_material_seed) S(default_north) S(default_position) S(default_ray_seed) S(default_samples) \
  S(default_target) S(default_width) \
  /* the form of the input files */ \
  S(extra_ignored) S(first_key) S(fov_unchecked) S(no_blank_lines) S(no_blanks_at_line_ends) S(no_leading_blanks) \
  S(no_tabs) S(same_names) \
  /* messages, statuses and the end */ \
  S(crash) S(empty_out) S(entity_colon) S(exit_0) S(exit_2) S(exit_255) S(extra_first) S(hang) S(message_more) \
  S(message_short) S(message_wrong) S(no_line_end) S(no_prefix) S(on_stdout) S(trimmed_line)

#define FIELD(name) bool name = false;
#define ENTRY(name) {#name, &on.name},
static struct { SWITCHES(FIELD) } on;
static const std::map<std::string, bool*> table{SWITCHES(ENTRY)};

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

struct Material { std::string kind; V reflectance{1, 1, 1}; double number = 0; };
struct Object { bool cylinder; V center{}; double radius = 0; V axis{}; int material = 0; };
struct Hit { double lambda; V point, normal; bool front; int material; bool base; };

struct Config {
  long width = 1920, aspect_w = 16, aspect_h = 9, samples = 20, depth = 5, material_seed = 13, ray_seed = 19;
  double gamma = 2.2, fov = 90;
  V position{0, 0, -10}, target, north{0, 1, 0}, dark{.25, .5, 1}, light{1, 1, 1};
};
static Config config;
static std::vector<Material> materials;
static std::vector<Object> objects;

// One of three generators, chosen when it is asked.
struct Random {
  std::mt19937_64 wide; std::mt19937 narrow; std::default_random_engine standard;
  void seed(std::uint64_t s) {
    wide.seed(s); narrow.seed(static_cast<std::uint32_t>(s)); standard.seed(static_cast<unsigned>(s));
  }
  double draw(double lo, double hi) {
    std::uniform_real_distribution<double> d(lo, hi);
    return on.mt32 ? d(narrow) : on.default_engine ? d(standard) : d(wide);
  }
};
static Random ray_random, material_random;

static bool counts(double lambda) {
  if (on.limit_0) return lambda > 0;
  return lambda >= (on.limit_1e_4 ? 1e-4 : on.limit_1e_8 ? 1e-8 : 1e-3);
}

static V random_vector(double extent) {
  auto draw = [&](double e) {
    V v;
    if (on.zyx) v.z = material_random.draw(-e, e), v.y = material_random.draw(-e, e), v.x = material_random.draw(-e, e);
    else v.x = material_random.draw(-e, e), v.y = material_random.draw(-e, e), v.z = material_random.draw(-e, e);
    return v;
  };
  while (on.unit_vectors || on.ball) {
    V v = draw(1);
    double squared = dot(v, v);
    if (squared > 1 || squared < 1e-160) continue;
    return extent * (on.ball ? v : v / std::sqrt(squared));
  }
  return on.cube_normalised ? extent * unit(draw(1)) : draw(extent);
}

static void consider(std::optional<Hit>& best, const Hit& hit) {
  if (!best || hit.lambda < best->lambda || (hit.lambda == best->lambda && !hit.base && !on.tie_first)) best = hit;
}

static std::optional<Hit> hit_sphere(const Object& s, V o, V d) {
  V rc = s.center - o;
  double a = dot(d, d), b = (on.sign_of_b ? 2 : -2) * dot(d, rc);
  double c = dot(rc, rc) - (on.radius_not_squared ? s.radius : s.radius * s.radius);
  double delta = b * b - 4 * a * c;
  if (delta < 0) return {};
  double root = std::sqrt(delta), near = (-b - root) / (2 * a), far = (-b + root) / (2 * a);
  if (on.half_b) {
    double h = -dot(d, rc), q = std::sqrt(h * h - a * c);
    near = (-h - q) / a, far = (-h + q) / a;
  }
  double lambda = on.far_root || (!counts(near) && !on.first_root) ? far : near;
  if (!counts(lambda)) return {};
  V point = o + lambda * d;
  V normal = on.normal_not_divided ? point - s.center : (point - s.center) / s.radius;
  if (on.normal_inward) normal = V{} - normal;
  return Hit{lambda, point, normal, true, s.material, false};
}

static std::optional<Hit> hit_cylinder(const Object& s, V o, V d) {
  double h = norm(s.axis), half = on.height_double ? h : on.height_half ? h / 4 : h / 2;
  V a = on.axis_not_unit ? s.axis : s.axis / h, center = s.center;
  if (on.center_is_base) center = s.center + (h / 2) * (s.axis / h);
  std::optional<Hit> best;
  V rc = o - center, rp = rc - dot(rc, a) * a, dp = d - dot(d, a) * a;
  double A = dot(dp, dp), B = 2 * dot(rp, dp), C = dot(rp, rp) - s.radius * s.radius, delta = B * B - 4 * A * C;
  if (delta >= 0 && !on.no_side) {
    for (double lambda : {(-B - std::sqrt(delta)) / (2 * A), (-B + std::sqrt(delta)) / (2 * A)}) {
      V point = o + lambda * d;
      double along = dot(point - center, a);
      if (counts(lambda) && (std::abs(along) <= half || on.endless_side)) {
        V normal = (point - center) - along * a;
        best = Hit{lambda, point, on.side_unit ? unit(normal) : normal, true, s.material, false};
        break;
      }
      if (on.first_root) break;
    }
  }
  for (double sign : {1.0, -1.0}) {
    if (on.no_caps || (on.no_lower_cap && sign < 0)) continue;
    V n = sign * a, base = center + half * n;
    double slope = dot(d, n);
    if (std::abs(slope) < 1e-8) continue;
    double lambda = dot(base - o, n) / slope;
    V point = o + lambda * d;
    if (!counts(lambda) || (norm(point - base) > s.radius && !on.endless_caps)) continue;
    if (best && lambda >= best->lambda) continue;
    best = Hit{lambda, point, on.cap_not_turned ? a : n, true, s.material, true};
  }
  return best;
}

static std::optional<Hit> nearest(V o, V d) {
  std::optional<Hit> best;
  for (const Object& object : objects) {
    auto hit = object.cylinder ? hit_cylinder(object, o, d) : hit_sphere(object, o, d);
    if (!hit) continue;
    if (on.last_object) best = hit; else consider(best, *hit);
  }
  if (best) {
    best->front = dot(d, best->normal) < 0;
    if (!best->front && !on.no_flip) best->normal = V{} - best->normal;
  }
  return best;
}

static V background(V d) {
  double m = ((on.background_not_unit ? d.y : on.background_x ? unit(d).x : unit(d).y) + 1) / 2;
  if (on.background_swapped) m = 1 - m;
  return (1 - m) * config.light + m * config.dark;
}

static V color(V o, V d, long left) {
  if (left <= 0) return on.end_background ? background(d) : V{};
  if (on.rays_unit) d = unit(d);
  auto hit = nearest(o, d);
  if (!hit) return background(d);
  if (left == 1 && on.no_last_draws) return V{};
  const Material& m = materials[hit->material];
  V n = hit->normal, r;
  if (m.kind == "matte") {
    r = (on.matte_alone ? V{} : n) + random_vector(1);
    if (std::abs(r.x) < 1e-8 && std::abs(r.y) < 1e-8 && std::abs(r.z) < 1e-8) r = n;
  } else if (m.kind == "metal") {
    V mirrored = d - (2 * dot(d, n)) * n;
    if (!on.metal_not_unit && !on.metal_unit_after) mirrored = unit(mirrored);
    r = mirrored;
    if (!on.smooth_without_draws || m.number != 0) {
      V random = random_vector(on.clamp_diffusion ? std::min(1.0, m.number) : m.number);
      if (!on.no_diffusion) r = mirrored + random;
    }
    if (on.metal_unit_after) r = unit(r);
    if (on.absorb && dot(r, n) <= 0) return V{};
  } else {
    V u = on.refract_not_unit ? d : unit(d);
    double cosine = std::min(-dot(u, n), 1.0), sine = std::sqrt(1 - cosine * cosine);
    double ratio = on.rho_never || hit->front == on.rho_swapped ? m.number : 1 / m.number;
    bool reflects = ratio * sine > 1 && !on.no_total_reflection;
    if (on.schlick && !reflects) {
      double r0 = (1 - ratio) / (1 + ratio);
      reflects = r0 * r0 + (1 - r0 * r0) * std::pow(1 - cosine, 5) > material_random.draw(0, 1);
    }
    if (reflects) r = u - (2 * dot(u, n)) * n;
    else { V p = ratio * (u + cosine * n); r = p - std::sqrt(std::abs(1 - dot(p, p))) * n; }
  }
  V start = hit->point;
  if (on.bias_1e_3) start = start + 1e-3 * n;
  if (on.bias_1e_4) start = start + 1e-4 * n;
  if (on.bias_direction) start = start + 1e-4 * r;
  V reflected = color(start, r, on.glass_free && m.kind == "refractive" ? left : left - 1);
  if (on.no_reflectance) return reflected;
  return (on.reflectance_squared ? m.reflectance * m.reflectance : m.reflectance) * reflected;
}

// Returns the picture in linear light. Needs the configuration and the scene.
static std::vector<V> render(long width, long height) {
  auto reseed = [&](std::uint64_t add) {
    std::uint64_t rays = config.ray_seed, scatter = config.material_seed;
    if (on.seeds_swapped) std::swap(rays, scatter);
    if (on.unseeded) rays = scatter = std::mt19937_64::default_seed;
    if (on.random_seed) rays = std::random_device()();
    ray_random.seed(rays + add); material_random.seed(scatter + add);
  };
  reseed(0);
  V vf = config.position - config.target;
  double angle = on.fov_degrees ? config.fov : config.fov * M_PI / 180;
  double hp = 2 * std::tan(on.fov_not_halved ? angle : angle / 2) * norm(vf);
  double ratio = static_cast<double>(config.aspect_w) / config.aspect_h;
  double wp = hp * (on.aspect_pair ? ratio : static_cast<double>(width) / height);
  V back = on.vf_not_unit ? vf : unit(vf), u = cross(on.north_ignored ? V{0, 1, 0} : config.north, back);
  if (!on.u_not_unit) u = unit(u);
  V v = cross(back, u), ph = wp * u, pv = (on.pv_positive ? hp : -hp) * v;
  V dx = ph / (on.pixels_less_one ? width - 1 : width), dy = pv / (on.pixels_less_one ? height - 1 : height);
  V origin = config.position - vf - 0.5 * (ph + pv);
  if (!on.origin_without_half) origin = origin + 0.5 * (dx + dy);
  if (on.printed_q) origin = config.position;

  std::vector<V> sums(static_cast<std::size_t>(width) * height);
  auto sample = [&](long row, long column, long number) {
    long index = row * width + column;
    bool starts_row = column == 0 && number == 0;
    if (on.seed_per_row && starts_row) reseed(0);
    if (on.seed_plus_row && starts_row) reseed(row);
    if (on.seed_per_pixel && number == 0) reseed(0);
    if (on.seed_plus_pixel && number == 0) reseed(index);
    if (on.seed_per_sample) reseed(0);
    if (on.threads && starts_row && row % ((height + 3) / 4) == 0) reseed(0);
    Random& random = on.one_generator ? material_random : ray_random;
    double x = 0, y = 0, lo = on.offset_0_to_1 ? 0 : -.5, hi = lo + 1, half = on.half_twice ? .5 : 0;
    if (on.y_before_x) { y = random.draw(lo, hi); x = random.draw(lo, hi); }
    else if (!on.no_offset) { x = random.draw(lo, hi); y = random.draw(lo, hi); }
    V q = origin + (column + half + x) * dx + (row + half + y) * dy, d = q - config.position;
    if (on.directions_unit) d = unit(d);
    V c = color(config.position, d, config.depth + on.depth_more - on.depth_less);
    double power = 1 / config.gamma;
    if (on.gamma_first) c = {std::pow(c.x, power), std::pow(c.y, power), std::pow(c.z, power)};
    sums[index] = sums[index] + c;
  };
  long samples = config.samples;
  if (on.columns_first) {
    for (long c = 0; c < width; c++) for (long r = 0; r < height; r++) for (long s = 0; s < samples; s++) sample(r, c, s);
  } else if (on.rows_upwards) {
    for (long r = height; r-- > 0;) for (long c = 0; c < width; c++) for (long s = 0; s < samples; s++) sample(r, c, s);
  } else if (on.samples_outermost) {
    for (long s = 0; s < samples; s++) for (long r = 0; r < height; r++) for (long c = 0; c < width; c++) sample(r, c, s);
  } else {
    for (long r = 0; r < height; r++) for (long c = 0; c < width; c++) for (long s = 0; s < samples; s++) sample(r, c, s);
  }
  for (V& sum : sums) sum = sum / samples;
  return sums;
}

static int byte(double mean) {
  double power = on.gamma_inverted ? config.gamma : 1 / config.gamma;
  double value = on.no_gamma || on.gamma_first ? mean : std::pow(mean, power);
  double scaled = (on.scale_256 ? 256 : on.scale_255_999 ? 255.999 : on.scale_254 ? 254 : 255) * value;
  if (on.rounded) scaled = std::round(scaled);
  return std::isnan(scaled) ? 0 : static_cast<int>(std::clamp(scaled, 0.0, 255.0));
}

// Returns the file of a picture.
static std::string written(const std::vector<V>& means, long width, long height) {
  std::string end = on.crlf ? "\r\n" : "\n", gap = on.tabs_between ? "\t" : on.two_blanks ? "  " : " ";
  std::ostringstream out;
  std::string size = std::to_string(width) + (on.size_on_two_lines ? "\n" : " ") + std::to_string(height);
  if (on.header_on_one_line) out << "P3 " << size << " 255\n";
  else out << "P3" << end << (on.comment ? "# a picture\n" : "") << size << end << "255" << end;
  for (long r = 0; r < height; r++) for (long c = 0; c < width; c++) {
    if (on.one_pixel_less && r + 1 == height && c + 1 == width) break;
    V mean = means[(on.upside_down ? height - 1 - r : r) * width + (on.mirrored ? width - 1 - c : c)];
    if (on.bgr) std::swap(mean.x, mean.z);
    std::string between = on.number_a_line ? "\n" : gap;
    out << byte(mean.x) << between << byte(mean.y) << between << byte(mean.z) << (on.blanks_at_line_ends ? " " : "");
    bool is_last = r + 1 == height && c + 1 == width;
    if (on.row_a_line && c + 1 < width) out << " ";
    else if (!is_last || !on.no_last_line_end) out << end;
  }
  return out.str();
}

// Ends the program with a message, whose lines after the first are `more`.
[[noreturn]] static void fail(const std::string& text, const std::string& more = "") {
  std::string all = "Error: " + text + "\n" + (on.message_short ? "" : more);
  if (on.no_line_end) all.pop_back();
  if (on.message_wrong) all.replace(0, 6, "error:");
  if (on.message_more) all += "The program ends.\n";
  (on.on_stdout ? std::cout : std::cerr) << all << std::flush;
  std::exit(on.exit_0 ? 0 : on.exit_255 ? 255 : on.exit_2 ? 2 : 1);
}

static std::string trimmed(const std::string& s) {
  auto from = s.find_first_not_of(" \t\r"), to = s.find_last_not_of(" \t\r");
  return from == std::string::npos ? "" : s.substr(from, to - from + 1);
}

// The words of a line, of which a wrong one makes the line wrong.
struct Words {
  std::istringstream in; bool good = true;
  explicit Words(const std::string& line) : in(line) {}
  std::string word() { std::string w; good = bool(in >> w) && good; return w; }
  double number() {
    std::string w = word();
    char* end;
    double value = std::strtod(w.c_str(), &end);
    good = good && *end == 0;
    return value;
  }
  long whole() {
    std::string w = word();
    char* end;
    long value = std::strtol(w.c_str(), &end, 10);
    good = good && *end == 0;
    return value;
  }
  V three() { double x = number(), y = number(), z = number(); return {x, y, z}; }
  void must(bool holds) { good = good && holds; }
  std::string rest() { in.clear(); std::string s; std::getline(in, s); return trimmed(s); }
};

static bool is_share(V v) { return std::min({v.x, v.y, v.z}) >= 0 && std::max({v.x, v.y, v.z}) <= 1; }

// Opens a file whose lines are read.
static std::ifstream opened(const char* path) {
  std::ifstream in(path);
  if (in) return in;
  if (!on.no_prefix) fail("cannot open " + std::string(path));
  std::cerr << "cannot open " << path << "\n";
  std::exit(1);
}

// Returns the lines that are not blank. Ends with the message `unknown` for a line that a mistake does not take.
static std::vector<std::string> lines(const char* path, const std::string& unknown) {
  std::vector<std::string> all;
  std::ifstream in = opened(path);
  for (std::string line; std::getline(in, line);) {
    std::string inner = trimmed(line);
    if (inner.empty() ? on.no_blank_lines : on.no_leading_blanks && line[0] != inner[0]) fail(unknown);
    if (on.no_tabs && !inner.empty() && line.find('\t') != std::string::npos) fail(unknown);
    if (!inner.empty()) all.push_back(line);
  }
  return all;
}

static void fail_by_more(const std::string& key, const std::string& more, const std::string& line = "") {
  fail("Extra data after configuration value for key: [" + key + "]", "Extra: \"" + more + "\"\n" + line);
}

static void read_config(const char* path) {
  Config& c = config;
  if (on.default_gamma) c.gamma = 1;
  if (on.default_samples) c.samples = 10;
  if (on.default_depth) c.depth = 10;
  if (on.default_fov) c.fov = 60;
  if (on.default_aspect) c.aspect_h = 10;
  if (on.default_width) c.width = 800;
  if (on.default_position) c.position.z = -9;
  if (on.default_target) c.target.y = 1;
  if (on.default_north) c.north.x = 1;
  if (on.default_dark) c.dark.x = .5;
  if (on.default_light) c.light.x = .9;
  if (on.default_material_seed) c.material_seed = 1;
  if (on.default_ray_seed) c.ray_seed = 1;
  std::set<std::string> seen;
  for (const std::string& line : lines(path, "Unknown configuration key: [:]")) {
    Words in(line);
    std::string key = in.word();
    if (on.no_blanks_at_line_ends && trimmed(line) != line) fail_by_more(key, "");
    Config old = c;
    if (key == "image_width:") in.must((c.width = in.whole()) > 0);
    else if (key == "aspect_ratio:") c.aspect_w = in.whole(), c.aspect_h = in.whole(), in.must(c.aspect_w > 0 && c.aspect_h > 0);
    else if (key == "gamma:") in.must((c.gamma = in.number()) > 0);
    else if (key == "camera_position:") c.position = in.three();
    else if (key == "camera_target:") c.target = in.three();
    else if (key == "camera_north:") c.north = in.three();
    else if (key == "field_of_view:") c.fov = in.number(), in.must(on.fov_unchecked || (c.fov > 0 && c.fov < 180));
    else if (key == "samples_per_pixel:") in.must((c.samples = in.whole()) > 0);
    else if (key == "max_depth:") in.must((c.depth = in.whole()) > 0);
    else if (key == "material_rng_seed:") in.must((c.material_seed = in.whole()) > 0);
    else if (key == "ray_rng_seed:") in.must((c.ray_seed = in.whole()) > 0);
    else if (key == "background_dark_color:") in.must(is_share(c.dark = in.three()));
    else if (key == "background_light_color:") in.must(is_share(c.light = in.three()));
    else fail("Unknown configuration key: [" + key + (key.back() == ':' ? "" : ":") + "]");
    std::string more = in.rest();
    bool is_more = !more.empty() && (in.good || on.extra_first);
    if (is_more && !on.extra_ignored) fail_by_more(key, more);
    if (!in.good) fail("Invalid value for key: [" + key + "]", "Line: \"" + line + "\"\n");
    if (on.first_key && !seen.insert(key).second) c = old;
  }
}

static void read_scene(const char* path) {
  std::map<std::string, int> names;
  for (const std::string& line : lines(path, "Unknown scene entity: ")) {
    Words in(line);
    std::string key = in.word(), kind = key.substr(0, key.size() - 1), name;
    std::string quoted = "Line: \"" + (on.trimmed_line ? trimmed(line) : line) + "\"\n";
    bool is_object = key == "sphere:" || key == "cylinder:";
    if (!is_object && key != "matte:" && key != "metal:" && key != "refractive:")
      fail("Unknown scene entity: " + (key.back() == ':' && !on.entity_colon ? kind : key));
    Material material{kind};
    Object object{key == "cylinder:"};
    if (is_object) {
      object.center = in.three();
      in.must((object.radius = in.number()) > 0);
      if (object.cylinder) object.axis = in.three();
      name = in.word();
    } else {
      name = in.word();
      if (key != "refractive:") in.must(is_share(material.reflectance = in.three()));
      if (key == "metal:") in.must((material.number = in.number()) >= 0);
      if (key == "refractive:") in.must((material.number = in.number()) > 0);
    }
    std::string more = in.rest();
    if (!more.empty() && (in.good || on.extra_first)) fail_by_more(key, more, quoted);
    if (!in.good) fail("Invalid " + kind + (is_object ? "" : " material") + " parameters", quoted);
    if (is_object) {
      if (!names.count(name)) fail("Material not found: [" + name + "]", quoted);
      object.material = names[name];
      objects.push_back(object);
    } else {
      if (!on.same_names && names.count(name)) fail("Material with name [" + name + "] already exists", quoted);
      names[name] = static_cast<int>(materials.size());
      materials.push_back(material);
    }
  }
}

int main(int argc, char** argv) {
  std::istringstream mistakes(std::getenv("MISTAKES") ? std::getenv("MISTAKES") : "");
  for (std::string name; std::getline(mistakes, name, ',');) {
    if (!table.count(name)) { std::cerr << "MISTAKES: there is no switch " << name << "\n"; return 64; }
    *table.at(name) = true;
  }
  if (argc != 4) fail("Invalid number of arguments: " + std::to_string(argc - 1));
  if (on.empty_out) std::ofstream{argv[3]};
  read_config(argv[1]);
  read_scene(argv[2]);
  if (on.crash) std::abort();
  for (volatile bool waits = on.hang; waits;) {}
  long ratio = config.aspect_w / config.aspect_h;
  double exact = config.width / (on.aspect_integers ? ratio : static_cast<double>(config.aspect_w) / config.aspect_h);
  double rounded = on.height_up ? std::ceil(exact) : on.height_nearest ? std::round(exact) : exact;
  long height = std::max(1L, static_cast<long>(rounded));
  std::vector<V> means;
  auto draw = [&] { means = render(config.width, height); };
  if (on.second_thread) std::thread(draw).join(); else draw();
  std::ofstream(argv[3]) << written(means, config.width, height);
}

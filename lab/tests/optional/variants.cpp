// The renderer of the statement in its simplest form, with one deviation that its first argument names:
//
//     g++ -std=c++20 -O2 -pthread variants.cpp -o variants
//     ./variants NAME CONFIG SCENE OUT.ppm
//
// The tests list the names. Some deviations are permitted, because the statement leaves them open, and all others are
// faults.
#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <functional>
#include <iostream>
#include <map>
#include <random>
#include <set>
#include <sstream>
#include <string>
#include <thread>
#include <vector>
#ifndef REAL
#define REAL double
#endif
using real = REAL;
static std::string variant;
static bool is(const char* name) { return variant == name; }
struct vec { real x{}, y{}, z{}; };
static vec operator+(vec a, vec b) { return {a.x+b.x, a.y+b.y, a.z+b.z}; }
static vec operator-(vec a, vec b) { return {a.x-b.x, a.y-b.y, a.z-b.z}; }
static vec operator-(vec a) { return {-a.x, -a.y, -a.z}; }
static vec operator*(vec a, real s) { return {a.x*s, a.y*s, a.z*s}; }
static vec operator*(vec a, vec b) { return {a.x*b.x, a.y*b.y, a.z*b.z}; }
static vec operator/(vec a, real s) { return {a.x/s, a.y/s, a.z/s}; }
static real dot(vec a, vec b) { return a.x*b.x + a.y*b.y + a.z*b.z; }
static vec cross(vec a, vec b) { return {a.y*b.z-a.z*b.y, a.z*b.x-a.x*b.z, a.x*b.y-a.y*b.x}; }
static real length(vec a) { return std::sqrt(dot(a, a)); }
static vec unit(vec a) { return a / length(a); }
struct material { int kind; vec reflectance; real extra; };
struct object { bool cylinder; vec center; real radius; vec axis; int material; };
struct hit { real lambda; vec point, normal; bool front; int material; };
struct settings {
  long width=1920, aw=16, ah=9, samples=20, depth=5, mseed=13, rseed=19;
  double gamma=2.2, fov=90, P[3]{0,0,-10}, D[3]{0,0,0}, N[3]{0,1,0}, dark[3]{.25,.5,1}, light[3]{1,1,1};
};
static const double LEAST_SMALL = 1e-8;
struct renderer {
  settings c; std::vector<material> materials; std::vector<object> objects; std::mt19937_64 mrng, rrng;
  real least = 1e-3;
  real draw(std::mt19937_64& g, double lo, double hi) { return std::uniform_real_distribution<double>(lo, hi)(g); }
  vec cube(real e) {
    vec s{};
    if (is("scatter-zyx")) { s.z = draw(mrng,-e,e); s.y = draw(mrng,-e,e); s.x = draw(mrng,-e,e); return s; }
    s.x = draw(mrng,-e,e); s.y = draw(mrng,-e,e); s.z = draw(mrng,-e,e);
    if (is("scatter-positive")) return {std::abs(s.x), std::abs(s.y), std::abs(s.z)};
    return s;
  }
  vec scattered(real e) {
    if (is("zero-not-drawn") && e == 0) return {};
    if (!is("published") && !is("published-zyx")) return cube(e);
    for (;;) { vec s = cube(1); real q = dot(s, s); if (q > 1e-30 && q <= 1) return s / std::sqrt(q) * e; }
  }
  void offer(hit& best, bool& found, vec d, real lambda, vec normal, vec point, int m) {
    if (found && !is("last-object")) { if (is("ties-first") ? lambda >= best.lambda : lambda > best.lambda) return; }
    bool front = dot(d, normal) < 0;
    best = {lambda, point, front || is("no-flip") ? normal : -normal, front, m}; found = true;
  }
  void sphere(const object& s, vec o, vec d, hit& best, bool& found) {
    vec rc = s.center - o;
    real a = dot(d, d), b = -2 * dot(d, rc), cc = dot(rc, rc) - s.radius * s.radius, disc = b*b - 4*a*cc;
    if (disc < 0) return;
    real root = std::sqrt(disc), lambda = (-b - root) / (2*a);
    if (is("half-b")) { real h = -dot(d, rc), q = std::sqrt(h*h - a*cc); lambda = (-h - q) / a; root = 2*q; }
    if (!(lambda >= least)) { if (is("first-root")) return; lambda = (-b + root) / (2*a); }
    if (is("far-root")) lambda = (-b + root) / (2*a);
    if (!(lambda >= least)) return;
    vec I = o + d * lambda;
    offer(best, found, d, lambda, (I - s.center) / (is("sphere-normal-long") ? 1 : s.radius), I, s.material);
  }
  void base(const object& s, vec o, vec d, vec n, real h, hit& best, bool& found) {
    real slope = dot(d, n);
    if (std::abs(slope) < LEAST_SMALL) return;
    vec B = s.center + n * (h / 2);
    real lambda = dot(B - o, n) / slope;
    if (!(lambda >= least)) return;
    vec I = o + d * lambda;
    if (length(I - B) <= s.radius || is("endless-caps")) offer(best, found, d, lambda, n, I, s.material);
  }
  void cylinder(const object& s, vec o, vec d, hit& best, bool& found) {
    real h = length(s.axis); vec u = s.axis / h;
    if (is("axis-half")) h *= 2;
    vec rc = o - s.center; rc = rc - u * dot(rc, u);
    vec dp = d - u * dot(d, u);
    real a = dot(dp, dp), b = 2 * dot(rc, dp), cc = dot(rc, rc) - s.radius * s.radius, disc = b*b - 4*a*cc;
    if (disc >= 0 && a > 0) {
      for (real sign : {real(-1), real(1)}) {
        real lambda = (-b + sign * std::sqrt(disc)) / (2*a);
        vec I = o + d * lambda;
        real along = dot(I - s.center, u);
        if (lambda >= least && (std::abs(along) <= h / 2 || is("endless-cylinder"))) {
          vec n = (I - s.center) - u * along;
          offer(best, found, d, lambda, is("side-normal-unit") ? n / s.radius : n, I, s.material);
          break;
        }
        if (is("first-root")) break;
      }
    }
    if (is("no-caps")) return;
    base(s, o, d, u, h, best, found);
    if (!is("one-cap")) base(s, o, d, -u, h, best, found);
  }
  vec color(vec o, vec d, long depth) {
    if (depth <= 0) return {};
    if (is("unit-rays")) d = unit(d);
    hit best{}; bool found = false;
    for (const object& s : objects) if (s.cylinder) cylinder(s, o, d, best, found); else sphere(s, o, d, best, found);
    vec light{(real)c.light[0], (real)c.light[1], (real)c.light[2]}, dark{(real)c.dark[0], (real)c.dark[1], (real)c.dark[2]};
    if (is("background-swapped")) std::swap(light, dark);
    if (!found) { real m = ((is("background-not-unit") ? d.y / 10 : unit(d).y) + 1) / 2; return light * (1 - m) + dark * m; }
    const material& m = materials[best.material];
    vec n = best.normal;
    if (is("no-draw-at-the-end") && depth == 1) return {};
    if (is("no-attenuation")) return color(best.point, n + scattered(1), depth - 1);
    if (m.kind == 0) {
      vec r = n + scattered(1);
      if (is("matte-no-normal")) r = r - n;
      if (std::abs(r.x) < LEAST_SMALL && std::abs(r.y) < LEAST_SMALL && std::abs(r.z) < LEAST_SMALL) r = n;
      return m.reflectance * color(best.point, r, depth - 1);
    }
    if (m.kind == 1) {
      vec r = d - n * (2 * dot(d, n));
      if (!is("metal-not-unit")) r = unit(r);
      vec s = scattered(m.extra);
      if (is("no-diffusion")) s = {};
      return m.reflectance * color(best.point, r + s, depth - 1);
    }
    vec u = unit(d); real cs = std::min(-dot(u, n), real(1)), sn = std::sqrt(1 - cs*cs);
    real ratio = best.front != is("rho-literal") ? 1 / m.extra : m.extra; vec r;
    if (ratio * sn > 1 && !is("no-total-reflection")) r = u - n * (2 * dot(u, n));
    else { vec p = (u + n * cs) * ratio; r = p - n * std::sqrt(std::abs(1 - dot(p, p))); }
    if (is("glass-straight")) r = u;
    return color(best.point, r, is("glass-free") ? depth : depth - 1);
  }
};
[[noreturn]] static void fail(const std::string& text, const std::string& more = "") {
  std::string all = "Error: " + text + "\n" + more;
  if (is("no-line-end")) all.pop_back();
  if (is("message-wrong")) all.replace(0, 6, "error:");
  if (is("message-short")) all = "Error: " + text + "\n";
  if (is("message-more")) all += "The program ends.\n";
  (is("stdout") ? std::cout : std::cerr) << all;
  std::cout.flush();
  std::exit(is("exit-0") ? 0 : is("exit-minus-1") ? 255 : is("exit-2") ? 2 : 1);
}
static std::string trimmed(const std::string& s) {
  auto a = s.find_first_not_of(" \t\r"), b = s.find_last_not_of(" \t\r");
  return a == std::string::npos ? "" : s.substr(a, b - a + 1);
}
static bool number(std::istringstream& in, double& to) {
  std::string word; if (!(in >> word)) return false;
  char* end; to = std::strtod(word.c_str(), &end); return *end == 0;
}
static bool whole(std::istringstream& in, long& to) {
  std::string word; if (!(in >> word)) return false;
  char* end; to = std::strtol(word.c_str(), &end, 10); return *end == 0;
}
static std::string rest(std::istringstream& in) { std::string s; std::getline(in, s); return trimmed(s); }
static bool shares(const double* v) { return std::all_of(v, v + 3, [](double x) { return x >= 0 && x <= 1; }); }
static void configuration(const char* path, settings& c) {
  if (is("defaults") || is("default-gamma")) c.gamma = 1;
  if (is("defaults") || is("default-samples")) c.samples = 10;
  if (is("defaults") || is("default-depth")) c.depth = 10;
  if (is("defaults") || is("default-fov")) c.fov = 60;
  if (is("defaults") || is("default-aspect")) c.ah = 10;
  if (is("defaults") || is("default-width")) c.width = 800;
  if (is("defaults") || is("default-position")) c.P[2] = -9;
  if (is("defaults") || is("default-target")) c.D[1] = 1;
  if (is("default-north")) c.N[0] = 1;
  if (is("defaults") || is("default-dark")) c.dark[0] = .5;
  if (is("defaults") || is("default-light")) c.light[0] = .9;
  if (is("defaults") || is("default-mseed")) c.mseed = 1;
  if (is("defaults") || is("default-rseed")) c.rseed = 1;
  std::ifstream f(path);
  if (!f) { if (is("no-prefix")) { std::cerr << "cannot open " << path << "\n"; std::exit(1); } fail("cannot open " + std::string(path)); }
  std::set<std::string> seen; std::string line;
  while (std::getline(f, line)) {
    std::istringstream in(line); std::string key;
    if (!(in >> key)) { if (is("blank-lines")) fail("Unknown configuration key: [:]"); continue; }
    if (is("leading-blanks") && line[0] != key[0]) fail("Unknown configuration key: [:]");
    if (is("tabs") && line.find('\t') != std::string::npos) fail("Unknown configuration key: [:]");
    if (is("trailing-blanks") && trimmed(line) != line) fail("Extra data after configuration value for key: [" + key + "]", "Extra: \"\"\n");
    settings old = c; bool good = true;
    auto three = [&](double* v) { return number(in, v[0]) && number(in, v[1]) && number(in, v[2]); };
    if (key == "image_width:") good = whole(in, c.width) && c.width > 0;
    else if (key == "aspect_ratio:") good = whole(in, c.aw) && whole(in, c.ah) && c.aw > 0 && c.ah > 0;
    else if (key == "gamma:") good = number(in, c.gamma) && c.gamma > 0;
    else if (key == "camera_position:") good = three(c.P);
    else if (key == "camera_target:") good = three(c.D);
    else if (key == "camera_north:") good = three(c.N);
    else if (key == "field_of_view:") good = number(in, c.fov) && (is("fov-unchecked") || (c.fov > 0 && c.fov < 180));
    else if (key == "samples_per_pixel:") good = whole(in, c.samples) && c.samples > 0;
    else if (key == "max_depth:") good = whole(in, c.depth) && c.depth > 0;
    else if (key == "material_rng_seed:") good = whole(in, c.mseed) && c.mseed > 0;
    else if (key == "ray_rng_seed:") good = whole(in, c.rseed) && c.rseed > 0;
    else if (key == "background_dark_color:") good = three(c.dark) && shares(c.dark);
    else if (key == "background_light_color:") good = three(c.light) && shares(c.light);
    else fail("Unknown configuration key: [" + key + (key.back() == ':' ? "" : ":") + "]");
    std::string more = rest(in);
    if (is("extra-first") && !good && std::istringstream(line.substr(line.find(':') + 1)) && !more.empty())
      fail("Extra data after configuration value for key: [" + key + "]", "Extra: \"" + more + "\"\n");
    if (!good) fail("Invalid value for key: [" + key + "]", "Line: \"" + line + "\"\n");
    if (!more.empty() && !is("extra-ignored")) fail("Extra data after configuration value for key: [" + key + "]", "Extra: \"" + more + "\"\n");
    if (is("first-key") && !seen.insert(key).second) c = old;
  }
}
static void scene(const char* path, renderer& r) {
  std::ifstream f(path);
  if (!f) { if (is("no-prefix")) { std::cerr << "cannot open " << path << "\n"; std::exit(1); } fail("cannot open " + std::string(path)); }
  std::map<std::string, int> names; std::string line;
  while (std::getline(f, line)) {
    std::istringstream in(line); std::string key, name;
    if (!(in >> key)) { if (is("blank-lines")) fail("Unknown scene entity: "); continue; }
    if (is("leading-blanks") && line[0] != key[0]) fail("Unknown scene entity: ");
    std::string shown = is("trimmed-line") ? trimmed(line) : line, kind = key.substr(0, key.size() - 1);
    bool is_material = key == "matte:" || key == "metal:" || key == "refractive:";
    if (!is_material && key != "sphere:" && key != "cylinder:") fail("Unknown scene entity: " + (is("entity-colon") ? key : trimmed(key.back() == ':' ? kind : key)));
    double v[7]{}; bool good = true; std::string quoted = "Line: \"" + shown + "\"\n";
    auto numbers = [&](int count) { for (int i = 0; i < count; i++) good = good && number(in, v[i]); };
    if (is_material) {
      good = bool(in >> name); numbers(key == "matte:" ? 3 : key == "metal:" ? 4 : 1);
      if (key != "refractive:") good = good && shares(v); else good = good && v[0] > 0;
      if (key == "metal:") good = good && v[3] >= 0;
    } else { numbers(key == "sphere:" ? 4 : 7); good = good && bool(in >> name) && v[3] > 0; }
    std::string more = rest(in);
    if (!good && is("extra-first") && !more.empty()) fail("Extra data after configuration value for key: [" + key + "]", "Extra: \"" + more + "\"\n" + quoted);
    if (!good) fail("Invalid " + kind + (is_material ? " material" : "") + " parameters", quoted);
    if (!more.empty()) fail("Extra data after configuration value for key: [" + key + "]", "Extra: \"" + more + "\"\n" + quoted);
    if (is_material) {
      if (!is("same-names") && !names.emplace(name, (int)r.materials.size()).second) fail("Material with name [" + name + "] already exists", quoted);
      names[name] = (int)r.materials.size();
      bool glass = key == "refractive:";
      vec reflectance{1, 1, 1}; if (!glass) reflectance = {(real)v[0], (real)v[1], (real)v[2]};
      if (is("red-and-blue")) std::swap(reflectance.x, reflectance.z);
      r.materials.push_back({key == "matte:" ? 0 : key == "metal:" ? 1 : 2, reflectance, (real)(glass ? v[0] : v[3])});
    } else {
      if (!names.count(name)) fail("Material not found: [" + name + "]", quoted);
      r.objects.push_back({key == "cylinder:", {(real)v[0], (real)v[1], (real)v[2]}, (real)v[3], {(real)v[4], (real)v[5], (real)v[6]}, names[name]});
    }
  }
}
int main(int argc, char** argv) {
  variant = argv[1];
  if (argc != 5) fail("Invalid number of arguments: " + std::to_string(argc - 2));
  if (is("empty-out")) { std::ofstream empty{argv[4]}; }
  if (is("hang")) for (volatile bool go = true; go;);
  renderer r; settings& c = r.c;
  configuration(argv[2], c); scene(argv[3], r);
  if (is("crash")) std::abort();
  r.mrng.seed(is("seeds-ignored") ? 1 : is("seeds-swapped") ? c.rseed : c.mseed); r.rrng.seed(is("seeds-ignored") ? 1 : is("seeds-swapped") ? c.mseed : c.rseed);
  if (is("random")) r.rrng.seed(std::random_device()());
  if (is("depth-more")) c.depth++;
  if (is("depth-less")) c.depth--;
  double ratio = (double)c.aw / c.ah, height = c.width / ratio;
  int W = c.width, H = std::max(1, (int)(is("height-up") ? std::ceil(height) : is("height-round") ? std::round(height) : std::floor(height)));
  auto v3 = [](const double* v) { return vec{(real)v[0], (real)v[1], (real)v[2]}; };
  vec P = v3(c.P), vf = P - v3(c.D);
  double angle = is("fov-degrees") ? c.fov : c.fov * M_PI / 180;
  real hp = 2 * std::tan(is("fov-whole") ? angle : angle / 2) * length(vf), wp = hp * (is("aspect-window") ? ratio : (double)W / H);
  vec u = unit(cross(v3(c.N), unit(vf))), v = cross(unit(vf), u), ph = u * wp, pv = -v * hp, dx = ph / W, dy = pv / H;
  if (is("mirrored")) { ph = -ph; dx = -dx; }
  vec O = P - vf - (ph + pv) / 2 + (dx + dy) / 2;
  if (is("corner")) O = O - (dx + dy) / 2;
  std::vector<vec> means((size_t)W * H);
  auto pixel = [&](int row, int col) {
    vec sum{};
    for (int s = 0; s < c.samples; s++) {
      real x, y, lo = is("offsets-0-1") ? 0 : -.5, hi = lo + 1;
      if (is("offset-yx")) { y = r.draw(r.rrng, lo, hi); x = r.draw(r.rrng, lo, hi); }
      else { x = r.draw(r.rrng, lo, hi); y = r.draw(r.rrng, lo, hi); }
      if (is("no-offsets")) x = y = 0;
      vec Q = O + dx * (col + x) + dy * (row + y);
      vec d = r.color(P, Q - P, c.depth);
      if (is("gamma-before-mean")) d = {(real)std::pow(d.x, 1/c.gamma), (real)std::pow(d.y, 1/c.gamma), (real)std::pow(d.z, 1/c.gamma)};
      sum = sum + d;
    }
    means[(size_t)row * W + col] = sum / (real)c.samples;
  };
  auto all = [&] {
    if (is("columns-first")) for (int col = 0; col < W; col++) for (int row = 0; row < H; row++) pixel(row, col);
    else if (is("bottom-up")) for (int row = H - 1; row >= 0; row--) for (int col = 0; col < W; col++) pixel(row, col);
    else for (int row = 0; row < H; row++) for (int col = 0; col < W; col++) pixel(row, col);
  };
  if (is("thread")) { std::thread t(all); t.join(); } else all();
  std::string eol = is("crlf") ? "\r\n" : "\n", gap = is("tab-between") ? "\t" : is("two-blanks") ? "  " : " ";
  std::ostringstream out;
  if (is("header-one-line")) out << "P3 " << W << ' ' << H << " 255\n";
  else out << "P3" << eol << (is("comment") ? "# a picture\n" : "") << W << (is("size-on-two-lines") ? "\n" : " ") << H << eol << "255" << eol;
  for (size_t i = 0; i < means.size(); i++) {
    size_t at = is("upside-down") ? (H - 1 - i / W) * W + i % W : i;
    real mean[3]{means[at].x, means[at].y, means[at].z}; int b[3];
    for (int k = 0; k < 3; k++) {
      double g = is("gamma-before-mean") || is("no-gamma") ? mean[k] : std::pow((double)mean[k], is("gamma-inverse") ? c.gamma : 1 / c.gamma);
      b[k] = std::clamp((int)(is("rounding") ? std::round(255 * g) : is("scale-255.999") ? 255.999 * g : is("scale-256") ? std::min(255., 256 * g) : std::trunc(255 * g)), 0, 255);
    }
    if (is("bgr")) std::swap(b[0], b[2]);
    bool last = i + 1 == means.size();
    if (is("number-per-line")) out << b[0] << '\n' << b[1] << '\n' << b[2] << '\n';
    else out << b[0] << gap << b[1] << gap << b[2] << (is("trailing-blanks-in-ppm") ? " " : "");
    if (is("row-per-line")) out << ((i + 1) % W ? " " : "\n");
    else if (!is("number-per-line") && !(last && is("no-last-end"))) out << eol;
  }
  std::ofstream file(argv[4]);
  if (is("one-pixel-less")) { std::string s = out.str(); file << s.substr(0, s.rfind('\n', s.size() - 2) + 1); }
  else file << out.str();
}

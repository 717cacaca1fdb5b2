// The renderer of the specification, written line by line in the simplest way: every ray is tested on every object,
// rays are traced by recursion, and nothing is computed ahead. Its times are a yardstick, and its bytes a second
// opinion. It takes valid files and checks nothing. With `published` after the names, surfaces scatter as in the
// published images: by a vector of length one, found by rejection.
//
//     g++ -std=c++20 -O3 -ffp-contract=off tests/literal/literal.cpp -o literal
//     ./literal CONFIG SCENE OUT.ppm [published]
// From GCC 16 on the library draws other numbers without this.
#define _GLIBCXX_USE_OLD_GENERATE_CANONICAL 1
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <iostream>
#include <map>
#include <random>
#include <sstream>
#include <string>
#include <vector>
struct vec { double x{}, y{}, z{}; };
static vec operator+(vec a, vec b) { return {a.x+b.x, a.y+b.y, a.z+b.z}; }
static vec operator-(vec a, vec b) { return {a.x-b.x, a.y-b.y, a.z-b.z}; }
static vec operator-(vec a) { return {-a.x, -a.y, -a.z}; }
static vec operator*(vec a, double s) { return {a.x*s, a.y*s, a.z*s}; }
static vec operator*(vec a, vec b) { return {a.x*b.x, a.y*b.y, a.z*b.z}; }
static vec operator/(vec a, double s) { return {a.x/s, a.y/s, a.z/s}; }
static double dot(vec a, vec b) { return a.x*b.x + a.y*b.y + a.z*b.z; }
static vec cross(vec a, vec b) { return {a.y*b.z-a.z*b.y, a.z*b.x-a.x*b.z, a.x*b.y-a.y*b.x}; }
static double length(vec a) { return std::sqrt(dot(a, a)); }
static vec unit(vec a) { return a / length(a); }
struct material { int kind; vec reflectance; double extra; };
struct object { bool cylinder; vec center; double radius; vec axis; int material; };
struct hit { double lambda; vec point, normal; bool front; int material; };
struct config { int width=1920, aw=16, ah=9, samples=20, depth=5; double gamma=2.2, fov=90; vec P{0,0,-10}, D{}, N{0,1,0}, dark{.25,.5,1}, light{1,1,1}; unsigned long long mseed=13, rseed=19; };
struct renderer {
  config c; std::vector<material> materials; std::vector<object> objects;
  std::mt19937_64 mrng, rrng; bool published = false;
  double draw(std::mt19937_64& g, double lo, double hi) { std::uniform_real_distribution<double> d(lo, hi); return d(g); }
  vec cube(double extent) { vec s{}; s.x = draw(mrng,-extent,extent); s.y = draw(mrng,-extent,extent); s.z = draw(mrng,-extent,extent); return s; }
  vec scattered(double extent) {
    if (!published) return cube(extent);
    for (;;) { vec s = cube(1); double squared = dot(s, s); if (squared > 1e-160 && squared <= 1) return s / std::sqrt(squared) * extent; }
  }
  void offer(hit& best, bool& found, vec o, vec d, double lambda, vec normal, vec point, int m, bool base = false) {
    if (found && (lambda > best.lambda || (base && lambda == best.lambda))) return;
    bool front = dot(d, normal) < 0;
    best = {lambda, point, front ? normal : -normal, front, m}; found = true;
  }
  void sphere(const object& s, vec o, vec d, hit& best, bool& found) {
    vec rc = s.center - o;
    double a = dot(d, d), b = -2 * dot(d, rc), cc = dot(rc, rc) - s.radius * s.radius;
    double disc = b*b - 4*a*cc;
    if (disc < 0) return;
    double lambda = (-b - std::sqrt(disc)) / (2*a);
    if (!(lambda >= 1e-3)) lambda = (-b + std::sqrt(disc)) / (2*a);
    if (!(lambda >= 1e-3)) return;
    vec I = o + d * lambda;
    offer(best, found, o, d, lambda, (I - s.center) / s.radius, I, s.material);
  }
  void base(const object& s, vec o, vec d, vec n, double h, hit& best, bool& found) {
    double slope = dot(d, n);
    if (std::abs(slope) < 1e-8) return;
    vec B = s.center + n * (h / 2);
    double lambda = dot(B - o, n) / slope;
    if (!(lambda >= 1e-3)) return;
    vec I = o + d * lambda;
    if (length(I - B) <= s.radius) offer(best, found, o, d, lambda, n, I, s.material, true);
  }
  void cylinder(const object& s, vec o, vec d, hit& best, bool& found) {
    double h = length(s.axis); vec u = s.axis / h;
    vec rc = o - s.center; rc = rc - u * dot(rc, u);
    vec dp = d - u * dot(d, u);
    double a = dot(dp, dp), b = 2 * dot(rc, dp), cc = dot(rc, rc) - s.radius * s.radius;
    double disc = b*b - 4*a*cc;
    if (disc >= 0) {
      for (double sign : {-1.0, 1.0}) {
        double lambda = (-b + sign * std::sqrt(disc)) / (2*a);
        vec I = o + d * lambda;
        double along = dot(I - s.center, u);
        if (lambda >= 1e-3 && std::abs(along) <= h / 2) {
          offer(best, found, o, d, lambda, (I - s.center) - u * along, I, s.material);
          break;
        }
      }
    }
    base(s, o, d, u, h, best, found);
    base(s, o, d, -u, h, best, found);
  }
  vec color(vec o, vec d, int depth) {
    if (depth <= 0) return {};
    hit best{}; bool found = false;
    for (const object& s : objects) if (s.cylinder) cylinder(s, o, d, best, found); else sphere(s, o, d, best, found);
    if (!found) { double m = (unit(d).y + 1) / 2; return c.light * (1 - m) + c.dark * m; }
    const material& m = materials[best.material];
    vec n = best.normal;
    if (m.kind == 0) {
      vec r = n + scattered(1);
      if (std::abs(r.x) < 1e-8 && std::abs(r.y) < 1e-8 && std::abs(r.z) < 1e-8) r = n;
      return m.reflectance * color(best.point, r, depth - 1);
    }
    if (m.kind == 1) {
      vec r = unit(d - n * (2 * dot(d, n)));
      return m.reflectance * color(best.point, r + scattered(m.extra), depth - 1);
    }
    vec u = unit(d); double cs = std::min(-dot(u, n), 1.0), sn = std::sqrt(1 - cs*cs);
    double ratio = best.front ? 1 / m.extra : m.extra; vec r;
    if (ratio * sn > 1) r = u - n * (2 * dot(u, n));
    else { vec p = (u + n * cs) * ratio; r = p - n * std::sqrt(std::abs(1 - dot(p, p))); }
    return color(best.point, r, depth - 1);
  }
};
int main(int argc, char** argv) {
  renderer r; config& c = r.c; std::string line, key;
  for (std::ifstream f(argv[1]); std::getline(f, line);) {
    std::istringstream in(line); if (!(in >> key)) continue;
    auto v = [&](vec& x) { in >> x.x >> x.y >> x.z; };
    if (key == "image_width:") in >> c.width; else if (key == "aspect_ratio:") in >> c.aw >> c.ah; else if (key == "gamma:") in >> c.gamma;
    else if (key == "camera_position:") v(c.P); else if (key == "camera_target:") v(c.D); else if (key == "camera_north:") v(c.N);
    else if (key == "field_of_view:") in >> c.fov; else if (key == "samples_per_pixel:") in >> c.samples; else if (key == "max_depth:") in >> c.depth;
    else if (key == "material_rng_seed:") in >> c.mseed; else if (key == "ray_rng_seed:") in >> c.rseed;
    else if (key == "background_dark_color:") v(c.dark); else if (key == "background_light_color:") v(c.light);
  }
  std::map<std::string, int> names;
  for (std::ifstream f(argv[2]); std::getline(f, line);) {
    std::istringstream in(line); if (!(in >> key)) continue;
    std::string name;
    if (key == "matte:" || key == "metal:" || key == "refractive:") {
      material m{}; in >> name; m.kind = key == "matte:" ? 0 : key == "metal:" ? 1 : 2; m.reflectance = {1,1,1};
      if (m.kind < 2) in >> m.reflectance.x >> m.reflectance.y >> m.reflectance.z;
      if (m.kind > 0) in >> m.extra;
      names[name] = r.materials.size(); r.materials.push_back(m);
    } else {
      object o{}; o.cylinder = key == "cylinder:"; in >> o.center.x >> o.center.y >> o.center.z >> o.radius;
      if (o.cylinder) in >> o.axis.x >> o.axis.y >> o.axis.z;
      in >> name; o.material = names[name]; r.objects.push_back(o);
    }
  }
  r.published = argc > 4 && std::string(argv[4]) == "published";
  r.mrng.seed(c.mseed); r.rrng.seed(c.rseed);
  int W = c.width, H = std::max(1, (int)std::floor(W / ((double)c.aw / c.ah)));
  vec vf = c.P - c.D; double hp = 2 * std::tan(c.fov * M_PI / 180 / 2) * length(vf), wp = hp * ((double)W / H);
  vec u = unit(cross(c.N, unit(vf))), v = cross(unit(vf), u), ph = u * wp, pv = -v * hp, dx = ph / W, dy = pv / H;
  vec O = c.P - vf - (ph + pv) / 2 + (dx + dy) / 2;
  std::vector<unsigned char> image; image.reserve((size_t)W * H * 3);
  for (int row = 0; row < H; row++) for (int col = 0; col < W; col++) {
    vec sum{};
    for (int s = 0; s < c.samples; s++) {
      double x = r.draw(r.rrng, -.5, .5), y = r.draw(r.rrng, -.5, .5);
      vec Q = O + dx * (col + x) + dy * (row + y);
      sum = sum + r.color(c.P, Q - c.P, c.depth);
    }
    sum = sum / c.samples;
    for (double ch : {sum.x, sum.y, sum.z}) {
      double byte = std::trunc(255 * std::pow(ch, 1 / c.gamma));
      image.push_back(byte >= 0 ? (unsigned char)std::min(255.0, byte) : 0);  // a mean that is not a number gives 0
    }
  }
  std::ofstream out(argv[3]); out << "P3\n" << W << ' ' << H << "\n255\n";
  for (size_t i = 0; i < image.size(); i += 3) out << (int)image[i] << ' ' << (int)image[i+1] << ' ' << (int)image[i+2] << '\n';
}

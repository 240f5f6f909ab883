// SPDX-License-Identifier: GPL-3.0-or-later
// Prints how far each tool form and normal rule is from the exact surface, on a fillet and on a sphere.
#include <cstdio>
#include <memory>

#include "solver/geometry/analytic_surface.h"
#include "solver/geometry/height_surface.h"
#include "solver/geometry/mesh_surface.h"
#include "solver/geometry/nagata_surface.h"
#include "solver/geometry/surface_error.h"
#include "tests/geometry/test_shapes.h"

namespace hydroscope {
namespace {

using test::at;
using test::Dice;

constexpr double kRadius = 10.0;
constexpr double kHalf = 30.0;  // half width of the box whose corner is the fillet
constexpr const char* kRules[] = {"plain", "area", "angle", "max"};

/// A box with rounded corners, rows of 5 mm along z; flats as fine as the corner at its ends, or in one
/// piece.
TriangleMesh make_box(int corner_facets, bool is_graded) {
  std::vector<Vec2> outline = make_rounded_outline(kHalf, kHalf, kRadius, corner_facets, is_graded ? 40 : 2);
  if (!is_graded) {
    // Two flat facets: take out the point in the middle, so that one is left.
    std::erase_if(outline, [](const Vec2& p) { return p.cwiseAbs().minCoeff() < 1e-9; });
  }
  const int count = static_cast<int>(outline.size());
  return make_grid_mesh(count + 1, 9, [&](int i, int j) {
    const Vec2& p = outline[at(i % count)];
    return Vec3(p.x(), p.y(), 5.0 * (j - 4));
  });
}

/// On the fillet, `beyond` mm farther at both ends: onto the flats, or less than the whole fillet.
std::vector<Vec3> scatter_on_fillet(double beyond) {
  Dice dice(1);
  std::vector<Vec3> points;
  const double arc = 0.5 * std::numbers::pi * kRadius;
  for (int i = 0; i < 20000; ++i) {
    const double s = dice.number(-beyond, arc + beyond), z = dice.number(-12, 12);
    const double a = std::clamp(s, 0.0, arc) / kRadius;
    Vec3 x(kHalf - kRadius + kRadius * std::cos(a), kHalf - kRadius + kRadius * std::sin(a), z);
    if (s < 0.0) x.y() += s;
    if (s > arc) x.x() -= s - arc;
    points.push_back(x);
  }
  return points;
}

void print_row(const char* name, const SurfaceError& e) {
  std::printf("%10s %10.2e %10.2e %9.3f %9.3f %10.2e\n", name, e.gap_rms, e.gap_max, e.normal_rms,
              e.normal_max, e.curvature_rms);
}

void print_head(const char* first) {
  std::printf("%10s %10s %10s %9s %9s %10s\n", first, "gap rms", "gap max", "n rms", "n max", "dn/dx rms");
}

using Tool = std::shared_ptr<const ToolSurface>;

Tool make_form(const std::string& form, const TriangleMesh& mesh, NormalRule rule) {
  if (form == "nagata")
    return std::make_shared<NagataSurface>(mesh, NagataSurfaceOptions{rule, 60, SearchRule::tree});
  MeshSurfaceOptions options;
  options.normals = form == "facet n" ? NormalRule::facet : rule;
  options.crease_angle = 60;
  options.is_smooth = form == "smooth";
  if (form == "quads") {
    for (int f = 0; f + 1 < static_cast<int>(mesh.triangles.size()); f += 2)
      options.quads.push_back({f, f + 1});
  }
  return std::make_shared<MeshSurface>(mesh, options);
}

/// The corner seen along its diagonal, sampled from a very fine mesh.
Tool make_points(double pitch) {
  TriangleMesh mesh = make_box(180, true);
  const Mat3 frame = make_frame(Vec3(1, 1, 0));
  TriangleMesh corner;
  corner.points = mesh.points;
  for (const auto& t : mesh.triangles) {
    bool is_near = true;
    for (int p : t) is_near = is_near && mesh.points[at(p)].head<2>().minCoeff() > 5.0;
    if (is_near) corner.triangles.push_back(t);
  }
  for (Vec3& p : corner.points) p = frame.transpose() * p;
  Pose pose;
  pose.rotation = frame;
  return std::make_shared<HeightSurface>(sample_heights(corner, pitch, "corner"), pose);
}

void print_forms(const ToolSurface& exact) {
  for (int facets : {45, 30, 18, 12, 9, 6, 4, 3}) {
    const double angle = 90.0 / facets;
    const double chord = kRadius * angle * std::numbers::pi / 180;
    const std::vector<Vec3> whole = scatter_on_fillet(2.0);
    const std::vector<Vec3> middle =
        scatter_on_fillet(-chord);  // without the facets beside the tangent lines
    std::printf("\nfillet of R = %g mm in facets of %g deg (%.3g mm), area-weighted normals [mm, deg]\n",
                kRadius, angle, chord);
    std::printf("%10s | %-49s | %s\n", "", "fillet and 2 mm of its flats", "its middle");
    std::printf("%10s | %9s %9s %9s %9s %9s | %9s %9s\n", "form", "gap rms", "gap max", "n rms", "n max",
                "dn/dx rms", "gap max", "n max");
    const TriangleMesh mesh = make_box(facets, true);
    const auto print = [&](const char* name, const ToolSurface& tool) {
      const SurfaceError all = measure_surface_error(tool, exact, whole, 3.0);
      const SurfaceError most = measure_surface_error(tool, exact, middle, 3.0);
      std::printf("%10s | %9.2e %9.2e %9.3f %9.3f %9.2e | %9.2e %9.4f\n", name, all.gap_rms, all.gap_max,
                  all.normal_rms, all.normal_max, all.curvature_rms, most.gap_max, most.normal_max);
    };
    for (const char* form : {"facet n", "facets", "quads", "smooth", "nagata"}) {
      print(form, *make_form(form, mesh, NormalRule::area));
    }
    print("points", *make_points(chord));
  }
}

void print_rules(const ToolSurface& exact) {
  const std::vector<Vec3> points = scatter_on_fillet(2.0);
  for (bool is_graded : {true, false}) {
    std::printf("\nfillet in facets of 9 deg, flats %s [mm, deg]\n",
                is_graded ? "as fine beside it" : "in one facet of 40 mm");
    for (const char* form : {"smooth", "nagata"}) {
      print_head(form);
      for (const char* rule : kRules) {
        const Tool tool = make_form(form, make_box(10, is_graded), parse_normal_rule(rule));
        print_row(rule, measure_surface_error(*tool, exact, points, 3.0));
      }
    }
  }
}

class Sphere final : public ToolSurface {
 public:
  std::optional<FootPoint> find_foot_point(const Vec3& x, double, double, SearchHint&) const override {
    FootPoint foot;
    foot.normal = foot.gap_gradient = x.normalized();
    foot.gap = x.norm() - kRadius;
    foot.normal_gradient = (Mat3::Identity() - foot.normal * foot.normal.transpose()) / x.norm();
    return foot;
  }
  const TriangleMesh& display_mesh() const override { return mesh_; }
  const std::vector<Vec3>& display_normals() const override { return normals_; }

 private:
  TriangleMesh mesh_;
  std::vector<Vec3> normals_;
};

void print_spheres() {
  Dice dice(2);
  std::vector<Vec3> points;
  for (int i = 0; i < 20000; ++i) points.push_back(kRadius * dice.direction());
  for (int times : {2, 3}) {
    const TriangleMesh mesh = test::make_icosphere(kRadius, times);
    std::printf("\nsphere of R = %g mm, %zu facets [mm, deg]\n", kRadius, mesh.triangles.size());
    for (const char* form : {"facets", "smooth", "nagata"}) {
      print_head(form);
      for (const char* rule : kRules) {
        print_row(rule, measure_surface_error(*make_form(form, mesh, parse_normal_rule(rule)), Sphere(),
                                              points, 3.0));
      }
    }
  }
}

void run() {
  const RoundedBoxSurface exact(Pose{}, {kHalf, kHalf, kRadius}, Side::outside, 20.0);
  print_forms(exact);
  print_rules(exact);
  print_spheres();
}

}  // namespace
}  // namespace hydroscope

int main() { hydroscope::run(); }

// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/render/synthetic.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace hydroscope {
namespace {

constexpr double kPi = std::numbers::pi;

/// Distance from the axis to a square with rounded corners, along an angle.
double calc_square_radius(double angle, double half_width, double corner) {
  const double folded = std::abs(std::remainder(angle, kPi / 2));  // 0 = middle of a flat
  const double c = std::cos(folded), s = std::sin(folded), inner = half_width - corner;
  const double flat = half_width / c;
  if (flat * s <= inner) return flat;
  // |r d - (inner, inner)| = corner
  const double b = inner * (c + s);
  return b + std::sqrt(std::max(0.0, b * b - 2.0 * inner * inner + corner * corner));
}

/// Square in the middle of the tube, round at its end: lofted in between.
double calc_die_radius(const SyntheticBulge& bulge, double angle, double z) {
  const double s = std::clamp((z / (0.5 * bulge.length) - 0.45) / 0.3, 0.0, 1.0);
  const double loft = s * s * (3.0 - 2.0 * s);
  const double square = calc_square_radius(angle, bulge.half_width, bulge.corner);
  return (1.0 - loft) * square + loft * (bulge.radius + 0.5 * bulge.thickness + 0.15);
}

Vec3 calc_place(double r, double angle, double z) { return {r * std::cos(angle), r * std::sin(angle), z}; }

SnapshotModel::Tool make_die(const SyntheticBulge& bulge) {
  SnapshotModel::Tool die;
  die.name = "die";
  const int around = bulge.is_whole_die ? 96 : 24, along = bulge.is_whole_die ? 48 : 24;
  const double turn = bulge.is_whole_die ? 2.0 * kPi : 0.5 * kPi;
  const double start = bulge.is_whole_die ? -0.55 * bulge.length : 0.0;
  const double rise = (0.55 * bulge.length - start) / along;
  for (int j = 0; j <= along; ++j)
    for (int i = 0; i <= around; ++i) {
      const double angle = turn * i / around, z = start + rise * j;
      die.mesh.points.push_back(calc_place(calc_die_radius(bulge, angle, std::abs(z)), angle, z));
    }
  const auto point = [&](int i, int j) { return j * (around + 1) + i; };
  for (int j = 0; j < along; ++j)
    for (int i = 0; i < around; ++i) {  // seen counter-clockwise from the axis
      die.mesh.triangles.push_back({point(i, j), point(i, j + 1), point(i + 1, j)});
      die.mesh.triangles.push_back({point(i + 1, j), point(i, j + 1), point(i + 1, j + 1)});
    }
  die.normals.assign(die.mesh.points.size(), Vec3::Zero());
  for (const auto& t : die.mesh.triangles) {
    const auto x = [&](int k) {
      return die.mesh.points[static_cast<std::size_t>(t[static_cast<std::size_t>(k)])];
    };
    for (int node : t) die.normals[static_cast<std::size_t>(node)] += (x(1) - x(0)).cross(x(2) - x(0));
  }
  for (Vec3& n : die.normals) n.normalize();
  return die;
}

}  // namespace

std::shared_ptr<const SnapshotModel> SyntheticBulge::make_model() const {
  auto model = std::make_shared<SnapshotModel>();
  model->title = "Tube blown into a square die";
  for (int j = 0; j < along; ++j)
    for (int i = 0; i < around; ++i) {
      const int a = j * (around + 1) + i, b = a + around + 1;
      model->quads.push_back({a, a + 1, b + 1, b});
    }
  model->mirrors = {
      {Vec3::Zero(), Vec3::UnitX()}, {Vec3::Zero(), Vec3::UnitY()}, {Vec3::Zero(), Vec3::UnitZ()}};
  if (has_die) model->tools.push_back(make_die(*this));
  return model;
}

std::shared_ptr<Snapshot> SyntheticBulge::make_snapshot(std::shared_ptr<const SnapshotModel> model,
                                                        double progress, int increment) const {
  auto s = std::make_shared<Snapshot>();
  s->model = std::move(model);
  s->increment = increment;
  s->time = progress;
  s->pressure = 60.0 * progress;
  s->feed = 4.0 * progress;
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for (int j = 0; j <= along; ++j)
    for (int i = 0; i <= around; ++i) {
      const double angle = 0.5 * kPi * i / around, z = 0.5 * length * j / along - s->feed * j / along;
      const double die = calc_die_radius(*this, angle, z) - 0.5 * thickness;
      const double blown =
          radius + (1.5 * half_width - radius) * progress * std::pow(std::cos(kPi * z / length), 2);
      const double gap = std::max(0.0, die - blown);
      const double r = std::min(die, blown);
      const Vec3 out(std::cos(angle), std::sin(angle), 0.0), around_axis(-out.y(), out.x(), 0.0);
      const double strain = std::max(0.0, r / radius - 1.0);
      const bool touches = gap < 1e-9;
      const double pressed = blown - die;  // how long ago it touched
      ContactClass c = ContactClass::kFree;
      if (touches) c = pressed > 1.2 ? ContactClass::kStick : ContactClass::kSlip;
      if (!touches && gap < 0.12 && progress > 0.2) c = ContactClass::kDetachedNow;
      s->points.push_back(r * out + z * Vec3::UnitZ());
      s->directors.push_back(out);
      s->thickness.push_back(thickness * (1.0 - 0.8 * strain));
      s->plastic_strain.push_back(1.15 * strain);
      s->contact_state.push_back(c);
      s->contact_tool.push_back(touches && has_die ? 0 : -1);
      s->gap.push_back(gap < 3.0 ? gap : nan);
      s->contact_pressure.push_back(touches ? s->pressure * std::min(1.0, 0.3 * pressed) : 0.0);
      s->contact_force.push_back(touches ? Vec3(-s->contact_pressure.back() * 4.0 * out)
                                         : Vec3(Vec3::Zero()));
      s->tool_normal.push_back(touches ? Vec3(-out) : Vec3(Vec3::Zero()));
      const double slide = touches ? 1.4 * strain * std::sin(2.0 * angle) : 0.0;
      s->slip.push_back(slide * around_axis - (touches ? 0.5 * s->feed * j / along : 0.0) * Vec3::UnitZ());
      s->slip_increment.push_back(c == ContactClass::kSlip ? Vec3(0.04 * s->slip.back())
                                                           : Vec3(Vec3::Zero()));
    }
  if (has_die) s->tool_translation.push_back(Vec3::Zero());
  s->quantities["r45_mm"] = 9.0;
  return s;
}

}  // namespace hydroscope

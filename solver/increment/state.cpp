// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/increment/state.h"

#include <cstring>

namespace hydroscope {

namespace {

void add_to_hash(std::uint64_t& hash, double value) {
  std::uint64_t bits;
  std::memcpy(&bits, &value, sizeof bits);
  for (int i = 0; i < 8; ++i, bits >>= 8) hash = (hash ^ (bits & 0xffU)) * 1099511628211ULL;
}

void add_to_hash(std::uint64_t& hash, const Vec3& v) {
  for (int i = 0; i < 3; ++i) add_to_hash(hash, v[i]);
}

}  // namespace

ElementNodes gather_nodes(const Model& model, const Configuration& c, std::size_t element) {
  ElementNodes nodes;
  for (std::size_t a = 0; a < 4; ++a) {
    const auto i = static_cast<std::size_t>(model.quads[element][a]);
    nodes.x[a] = c.x[i];
    nodes.triad[a] = c.triad[i];
    nodes.thickness[a] = c.thickness[i];
  }
  return nodes;
}

State make_initial_state(const Model& model) {
  State s;
  const auto n = static_cast<std::size_t>(model.n_nodes()), n_e = model.quads.size();
  const auto n_z = static_cast<std::size_t>(model.law.rule.size());
  s.configuration = {model.x0, model.triad0, std::vector<double>(n, model.thickness)};
  s.layers.resize(n_e * kGaussPoints * n_z);
  s.gauss.resize(n_e * kGaussPoints);
  for (std::size_t e = 0; e < n_e; ++e) {
    initialise_element(gather_nodes(model, s.configuration, e), model.axis, model.law.rule,
                       {std::span(s.layers).subspan(e * kGaussPoints * n_z, kGaussPoints * n_z),
                        std::span(s.gauss).subspan(e * kGaussPoints, kGaussPoints)});
  }
  s.contacts.assign(model.tools.size(), std::vector<ContactPoint>(n));
  s.recent_strain.assign(n_e, 0.0);
  s.sigma33.assign(n, 0.0);
  s.outer_pressure.assign(n, 0.0);
  s.wall.assign(n, model.thickness);
  s.area.assign(n, 0.0);
  s.reaction.assign(n, Vec3::Zero());
  s.volume = model.volume0;
  s.next_dt = model.increment.initial > 0.0 ? model.increment.initial : 0.01 * model.end_time;
  return s;
}

std::uint64_t calc_hash(const State& s) {
  std::uint64_t hash = 14695981039346656037ULL;
  for (const Vec3& x : s.configuration.x) add_to_hash(hash, x);
  for (const Triad& t : s.configuration.triad) {
    add_to_hash(hash, t.v1);
    add_to_hash(hash, t.v);
  }
  for (const LayerState& l : s.layers) {
    add_to_hash(hash, l.point.stress);
    add_to_hash(hash, l.point.plastic_strain);
    add_to_hash(hash, l.angle);
  }
  for (const GaussState& g : s.gauss) {
    add_to_hash(hash, Vec3(g.shear[0], g.shear[1], g.dilatation));
  }
  for (const auto& list : s.contacts) {
    for (const ContactPoint& c : list) {
      add_to_hash(hash, static_cast<double>(c.status));
      add_to_hash(hash, c.normal_force);
      add_to_hash(hash, c.friction);
      add_to_hash(hash, c.slip);
    }
  }
  for (const auto* field :
       {&s.configuration.thickness, &s.recent_strain, &s.sigma33, &s.outer_pressure, &s.wall, &s.area}) {
    for (const double value : *field) add_to_hash(hash, value);
  }
  for (const Vec3& r : s.reaction) add_to_hash(hash, r);
  for (const double value : {s.time, s.pressure, s.volume, s.last_dt, s.next_dt, s.peak_pressure}) {
    add_to_hash(hash, value);
  }
  return hash;
}

void move(Configuration& c, const Eigen::VectorXd& q) {
  for (std::size_t i = 0; i < c.x.size(); ++i) {
    const auto at = static_cast<Eigen::Index>(kDofs * i);
    c.x[i] += q.segment<3>(at);
    Triad& t = c.triad[i];
    const Vec3 theta = q[at + 3] * t.v1 + q[at + 4] * t.v2;
    const double angle = theta.norm();
    if (angle == 0.0) continue;
    const Mat3 turn = Eigen::AngleAxisd(angle, theta / angle).toRotationMatrix();
    t.v = (turn * t.v).normalized();
    const Vec3 v1 = turn * t.v1;  // kept exactly orthonormal, or fibres would drift over thousands of turns
    t.v1 = (v1 - t.v.dot(v1) * t.v).normalized();
    t.v2 = t.v.cross(t.v1);
  }
}

}  // namespace hydroscope

// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

#include "microslip/calibrate/growing_range.hpp"
#include "microslip/calibrate/joint_edges.hpp"

namespace microslip {
namespace {

/// Levels per joint: fewer hardly distinguish an edge from a smooth density.
constexpr std::size_t kFewestForEdges = 20;
/// Places of edges beside those found.
constexpr std::size_t kPlacesOfEdges = 8;

/// Edges whose ranges are not examined yet. @param places  x*, m; rising.
FoundEdges edges_at(std::vector<double> places) {
  FoundEdges edges;
  if (!places.empty()) edges.empty.assign(places.size() + 1, false);
  edges.slip_displacement = std::move(places);
  return edges;
}

}  // namespace

bool GrowingRange::edges_sought() const {
  return options_.edges && all_.size() >= kFewestForEdges * sought_.size();
}

/// Adds the edges of the joint that gains most by them. Joints that have some keep them.
/// @return whether there is one.
bool GrowingRange::find_edges(const CalibratedState& state) {
  double most = 0.0;
  std::size_t where = 0;
  std::vector<double> places;
  for (std::size_t j = 0; j < sought_.size(); ++j) {
    if (!edges_[j].slip_displacement.empty()) continue;
    JointEdges model(evidence_, state.linear, state.unknowns, j, bounds());
    const EdgedFit without = model.present(state.settled.weights);
    const EdgedFit found = model.find(without);
    if (tick_) tick_();
    const double gain = without.evidence - found.evidence;
    if (found.edges.empty() || !(gain > most)) continue;
    most = gain;
    where = j;
    places = model.slip_displacements(found.edges);
  }
  if (places.empty()) return false;
  edges_[where] = edges_at(std::move(places));
  return true;
}

/// Ranges between edges on which nothing slips, where that is likelier than not: both are as likely
/// before. Each with those of the others as they are.
void GrowingRange::find_emptiness(const CalibratedState& state) {
  for (std::size_t j = 0; j < sought_.size(); ++j) {
    FoundEdges& edges = edges_[j];
    edges.emptiness.assign(edges.empty.size(), 0.0);
    if (state.unknowns.of(j).edges().size() + 1 != edges.empty.size()) continue;
    const JointEdges model(evidence_, state.linear, state.unknowns, j, bounds());
    for (std::size_t range = 0; range < edges.empty.size(); ++range) {
      std::vector<bool> with = edges.empty;
      std::vector<bool> without = edges.empty;
      with[range] = false;
      without[range] = true;
      if (std::ranges::find(without, false) == without.end()) continue;
      const double fall = model.evidence_without(with, state.settled.weights) -
                          model.evidence_without(without, state.settled.weights);
      if (std::isnan(fall)) continue;
      edges.emptiness[range] = 1.0 / (1.0 + std::exp(-0.5 * fall));
      edges.empty[range] = edges.emptiness[range] > 0.5;
    }
  }
}

/// Removes edges: with other exponents and edges of the others some may not be worth their price.
/// @return whether there is one.
bool GrowingRange::thin_edges(const CalibratedState& state) {
  bool any = false;
  for (std::size_t j = 0; j < sought_.size(); ++j) {
    if (edges_[j].slip_displacement.empty()) continue;
    JointEdges model(evidence_, state.linear, state.unknowns, j, bounds());
    const EdgedFit kept = model.kept(state.settled.weights);
    if (tick_) tick_();
    if (kept.edges.size() == edges_[j].slip_displacement.size()) continue;
    any = true;
    edges_[j] = edges_at(model.slip_displacements(kept.edges));
  }
  return any;
}

// One joint after the other, as a jump that one of them leaves unexplained may be attributed to
// another.
CalibratedState GrowingRange::with_edges(CalibratedState state) {
  if (!edges_sought()) return state;
  state = steadied(std::move(state));
  while (find_edges(state)) state = with_new_edges(state);
  return thin_edges(state) ? with_new_edges(state) : state;
}

CalibratedState GrowingRange::with_new_edges(const CalibratedState& before) {
  const CalibratedState state = tried(before, exponents_);
  find_emptiness(state);
  return choose_exponents(state);
}

/// The evidence of the edges, and other places where they may be.
void GrowingRange::weigh_edges(const CalibratedState& found) {
  const std::vector<FoundEdges> before = edges_;
  find_emptiness(found);
  for (std::size_t j = 0; j < sought_.size(); ++j) edges_[j].empty = before[j].empty;
  for (std::size_t j = 0; j < sought_.size(); ++j) {
    FoundEdges& edges = edges_[j];
    edges.slip_displacement = found.unknowns.of(j).edges();
    if (edges.slip_displacement.empty()) continue;
    JointEdges model(evidence_, found.linear, found.unknowns, j, bounds());
    EdgeSearch search = model.search();
    const EdgedFit fit = model.present(found.settled.weights);
    edges.evidence = model.fit({}, 0.0, fit, true).evidence - fit.evidence;
    const std::vector<double> deviations = search.deviations(fit);
    for (std::size_t e = 0; e < fit.edges.size(); ++e) {
      std::vector<BasisEdge> moved = fit.edges;
      moved[e].at -= deviations[e];
      edges.deviation.push_back(edges.slip_displacement[e] - model.slip_displacements(moved)[e]);
    }
    for (const auto& places : search.elsewhere(fit, deviations, kPlacesOfEdges)) {
      edges.elsewhere.push_back(model.slip_displacements(places));
    }
  }
}

}  // namespace microslip

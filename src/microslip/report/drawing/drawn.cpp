// SPDX-License-Identifier: MIT
#include "microslip/report/drawing/drawn.hpp"

#include <algorithm>
#include <cstddef>
#include <utility>

namespace microslip {
namespace {

template <class LayerOfPoints>
Piece all_places(const LayerOfPoints& layer) {
  Piece places;
  places.reserve(layer.x.size() + 1);
  for (std::size_t i = 0; i < layer.x.size(); ++i) {
    const double x = layer.x[i];
    const double y = layer.y[i];
    places.push_back({.x = x, .y = y, .x_low = x, .x_high = x, .y_low = y, .y_high = y});
  }
  return places;
}

Piece places_of(const LineLayer& layer) { return all_places(layer); }

Piece places_of(const LoopLayer& layer) {
  Piece places = all_places(layer);
  places.push_back(places.front());
  return places;
}

Piece places_of(const PointLayer& layer) {
  Piece places = all_places(layer);
  for (std::size_t i = 0; i < layer.x_error.size(); ++i) {
    places[i].x_low -= layer.x_error[i];
    places[i].x_high += layer.x_error[i];
  }
  for (std::size_t i = 0; i < layer.y_error.size(); ++i) {
    places[i].y_low -= layer.y_error[i];
    places[i].y_high += layer.y_error[i];
  }
  return places;
}

Piece places_of(const BandLayer& layer) {
  Piece places;
  for (std::size_t i = 0; i < layer.x.size(); ++i) {
    const double x = layer.x[i];
    const double upper = layer.upper[i];
    places.push_back(
        {.x = x, .y = upper, .x_low = x, .x_high = x, .y_low = layer.lower[i], .y_high = upper});
  }
  return places;
}

Piece places_of(const BarLayer& layer) {
  Piece places = all_places(layer);
  for (Place& place : places) {
    place.x_low -= kHalfOfBars;
    place.x_high += kHalfOfBars;
    place.y_low = std::min(place.y, 0.0);
    place.y_high = std::max(place.y, 0.0);
  }
  return places;
}

Piece places_of(const MarkerLayer& /*layer*/) { return {}; }

}  // namespace

std::vector<Piece> drawn_pieces(const Layer& layer, bool log_x, bool log_y) {
  std::vector<Piece> pieces;
  if (!is_shown(layer)) return pieces;
  Piece piece;
  for (const Place& place :
       std::visit([](const auto& concrete) { return places_of(concrete); }, layer)) {
    if ((!log_x || place.x >= kSmallestOnLog) && (!log_y || place.y >= kSmallestOnLog)) {
      piece.push_back(place);
    } else if (!piece.empty()) {
      pieces.push_back(std::exchange(piece, {}));
    }
  }
  if (!piece.empty()) pieces.push_back(std::move(piece));
  return pieces;
}

bool anything_drawn(const Figure& figure) {
  return std::any_of(figure.layers.begin(), figure.layers.end(), [&](const Layer& layer) {
    return !drawn_pieces(layer, figure.x.log, figure.y.log).empty();
  });
}

}  // namespace microslip

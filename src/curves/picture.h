#pragma once
#include <string>
#include <vector>

#include "curves/drawing.h"
#include "curves/result.h"

namespace evc::curves {

/// A curve over the places of a picture, km/h; not a number where it does not exist.
struct PictureCurve {
  std::string key, name;
  Stroke stroke;
  std::vector<double> v;
};

/// The contents of both charts: every curve and limit over the line, the most restrictive of all
/// targets.
struct Picture {
  double from_m = 0.0, to_m = 0.0;
  double bottom_kmh = 0.0, top_kmh = 0.0;  // the lowest speed drawn: above 0 where nothing is below it
  std::vector<double> x_m;
  std::vector<PictureCurve> curves;
  struct Step {
    double from_m, value;
  };
  std::vector<Step> mrsp, gradient, under_train;  // under_train: the lowest gradient under the train
  struct Mark {
    double x_m;
    std::string name;
  };
  std::vector<Mark> marks;
  /// Where adhesion is reduced or a special brake does not count, by kind; a kind per row.
  struct Zone {
    double from_m, to_m;
    std::size_t row;
    std::string name;
  };
  std::vector<Zone> zones;
  std::size_t zone_rows = 0;
  Value V_release_kmh, start_of_RSM_m;
  double end_of_RSM_m = 0.0;  // the SvL
};
Picture picture_of(const Approached& approached);

}  // namespace evc::curves

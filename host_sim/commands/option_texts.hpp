/// Parses options that are one text. Each function throws UserError with the option, the text and the expected form.
#pragma once

#include <string>
#include <vector>

#include "host_sim/options/picture_options.hpp"
#include "host_sim/scenario/posed_aircraft.hpp"
#include "host_sim/sweep/draw_sweep.hpp"
#include "render_core/perception/edge_detector.hpp"
#include "render_core/raytrace/search/search_settings.hpp"

namespace tedavis::host_sim {

/// "1024x768"
[[nodiscard]] PictureSize size_from(const std::string& text);
/// "lat,lon,alt_m,heading,pitch,roll" in degrees and metres above mean sea level.
[[nodiscard]] AircraftPose pose_from(const std::string& text);
/// "lat,lon" or "lat,lon,alt_m": degrees, and metres above mean sea level.
[[nodiscard]] SweptPlace place_from(const std::string& text);
/// "3000,6000": metres from `least` to `most`, at most SweepRings::kMaxSteps of them.
[[nodiscard]] std::vector<double> metres_from(const std::string& option, const std::string& text, double least_m, double most_m);
/// Checks and returns the name of a phase.
[[nodiscard]] std::string phase_from(const std::string& name);
/// "sigma,low,high" of Canny's edges.
[[nodiscard]] perception::CannySettings canny_from(const std::string& text);
/// "exact", "cells", "ray" or "cones", the last three with steps and halvings, such as "ray:1024:12".
[[nodiscard]] raytrace::SearchSettings search_from(const std::string& text);
/// "2026-06-01T14:00:00Z"
[[nodiscard]] base::Time time_from(const std::string& text);

}  // namespace tedavis::host_sim

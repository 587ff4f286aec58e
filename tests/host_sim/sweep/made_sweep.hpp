/// A sweep as if it had been drawn: two heights, two distances, four bearings; two viewpoints are skipped.
#pragma once

#include "host_sim/sweep/swept_views.hpp"
#include "render_core/base/units.hpp"

namespace tedavis::test_support {

inline host_sim::Sweep made_sweep() {
    const host_sim::RgbaPicture picture{8, 6, std::vector<std::uint8_t>(8 * 6 * 4, 120)};
    const std::string png = host_sim::encode_small_png(host_sim::view_of(picture));
    host_sim::Sweep sweep;
    sweep.terrain = "a <b>.tdb";
    sweep.design = "default";
    sweep.device = "es3-mid";
    sweep.place = {base::radians(36.6), base::radians(-84.25), {300}};
    sweep.place_msl_m = 330;
    sweep.radius_m = 250;
    sweep.rings = {4, {3000, 6000}, {500, 1500}};
    const auto geoid = [](double, double) { return earth::GeoidUndulation{-30}; };
    for (const host_sim::Viewpoint& viewpoint : host_sim::viewpoints_round(sweep.place, geoid, sweep.rings)) {
        const std::size_t n = sweep.views.size() + sweep.skipped.size();
        if (n < 2) {
            sweep.skipped.push_back({viewpoint, n == 0 ? "below the ground" : "outside the terrain"});
            continue;
        }
        host_sim::SweptView view;
        view.viewpoint = viewpoint;
        view.file = viewpoint.name + ".png";
        view.hash = n;
        view.measures.clutter = 0.05 + 0.01 * static_cast<double>(n * 5 % 16);
        view.measures.layers = {{"terrain", 0.75, 0.9}, {"symbology", 0.25, 0.1}};
        view.sight = n % 5 == 0   ? host_sim::PlaceSight::outside_picture
                     : n % 3 == 0 ? host_sim::PlaceSight::behind_terrain
                                  : host_sim::PlaceSight::seen;
        if (view.sight != host_sim::PlaceSight::outside_picture) {
            view.place = {true, 100, 80, 12};
            view.saliency = {0.06, 0.02, 0.875};
        }
        view.small_png = png;
        sweep.views.push_back(view);
    }
    sweep.standing_out.push_back({"most clutter", most_cluttered(sweep.views), {4, 3.5}, png, png, png});
    sweep.standing_out.push_back({"least clutter", least_cluttered(sweep.views), {2, 2.5}, png, png, png});
    return sweep;
}

}  // namespace tedavis::test_support

#include "host_sim/contract/picture_readings.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "host_sim/evaluation/evaluated_flight.hpp"
#include "host_sim/measure/role_contrast.hpp"
#include "host_sim/measure/sign_contrast.hpp"
#include "render_core/perception/salient_places.hpp"

namespace tedavis::host_sim {
namespace {

constexpr double kNoRank = std::numeric_limits<double>::infinity();

bool is_left_out(const ContractCondition& condition, const std::string& layer) {
    return std::find(condition.without.begin(), condition.without.end(), layer) != condition.without.end();
}

std::size_t layer_place(const LayerMask& mask, const std::string& layer) {
    return static_cast<std::size_t>(std::find(mask.names.begin(), mask.names.end(), layer) - mask.names.begin());
}

ContractReading region_reading(double value, const perception::RegionGrid& grid, int column, int row,
                               const MeasuredFrame& frame) {
    const perception::PixelRegion box =
        perception::region_of(grid, column, row, static_cast<int>(frame.picture.width), static_cast<int>(frame.picture.height));
    const std::string cell = ", column " + std::to_string(column + 1) + " and row " + std::to_string(row + 1) + " of " +
                             std::to_string(grid.columns) + " x " + std::to_string(grid.rows);
    const bool is_third = grid.columns == 3 && grid.rows == 3;
    return {ReadingState::measured, value, box, region_name(grid, column, row) + (is_third ? "" : cell), {}};
}

/// Which pixels of a map may be places: the layers of the picture's pixels in their middles, and round them, are not left out.
/// What differs from its surroundings makes those salient, too.
class PlaceChoice {
public:
    PlaceChoice(const ContractCondition& condition, const LayerMask& mask, const perception::SaliencyMap& map)
        : mask_(mask), map_(map), width_(map.width), is_left_out_(256, false) {
        for (std::size_t n = 0; n < mask.names.size(); ++n) is_left_out_[n] = is_left_out(condition, mask.names[n]);
    }
    [[nodiscard]] std::vector<std::uint8_t> choose() const {
        std::vector<std::uint8_t> may(map_.values.size(), 1);
        for (int y = 0; y < map_.height; ++y)
            for (int x = 0; x < width_; ++x)
                if (is_beside(x, y)) may[perception::pixels_of(width_, y) + static_cast<std::size_t>(x)] = 0;
        return may;
    }

private:
    static constexpr int kBeside = 2;  // pixels of the map: its finest centre and what that is compared with
    [[nodiscard]] bool is_beside(int x, int y) const {
        for (int row = std::max(y - kBeside, 0); row <= std::min(y + kBeside, map_.height - 1); ++row)
            for (int column = std::max(x - kBeside, 0); column <= std::min(x + kBeside, width_ - 1); ++column)
                if (is_left_out_[mask_
                                     .layers[std::size_t{middle(row, mask_.height)} * mask_.width + middle(column, mask_.width)]])
                    return true;
        return false;
    }
    [[nodiscard]] std::uint32_t middle(int cell, std::uint32_t side) const {
        return std::min((static_cast<std::uint32_t>(cell) << map_.level) + ((1u << map_.level) >> 1), side - 1);
    }

    const LayerMask& mask_;
    const perception::SaliencyMap& map_;
    int width_;
    std::vector<bool> is_left_out_;  ///< by numbers of layers
};

perception::SalientPlaces places_of(const ContractCondition& condition, const MeasuredFrame& frame) {
    const perception::SaliencyMap map = frame.meter.saliency_map();
    const double radius_px = condition.focus_share * std::min(frame.picture.width, frame.picture.height);
    std::vector<std::uint8_t> may;
    if (!condition.without.empty()) may = PlaceChoice(condition, *frame.mask, map).choose();
    return perception::salient_places(map, radius_px, perception::kMaxSalientPlaces, {may.data(), may.size()});
}

double rank_of(const FrameObstacle& obstacle, const perception::SalientPlaces& places, double radius_px) {
    if (obstacle.state != "drawn") return kNoRank;
    const double x = 0.5 * (obstacle.box[0] + obstacle.box[2]), y = 0.5 * (obstacle.box[1] + obstacle.box[3]);
    for (std::size_t n = 0; n < places.size(); ++n)
        if (std::hypot(places[n].x - x, places[n].y - y) <= radius_px) return static_cast<double>(n + 1);
    return kNoRank;
}

perception::PixelRegion whole_pixels(const FrameObstacle& obstacle) {
    const auto& box = obstacle.box;
    return {static_cast<int>(std::floor(box[0])), static_cast<int>(std::floor(box[1])), static_cast<int>(std::ceil(box[2])),
            static_cast<int>(std::ceil(box[3]))};
}

}  // namespace

std::string third_of(const perception::PixelRegion& box, int width, int height) {
    const auto third = [](int low, int high, int side) { return std::clamp(3 * (low + high) / (2 * std::max(side, 1)), 0, 2); };
    return region_name({3, 3}, third(box.left, box.right, width), third(box.top, box.bottom, height));
}

ContractReading clutter_reading(const ContractCondition& condition, const MeasuredFrame& frame) {
    if (condition.region == ClutterRegion::picture)
        return {ReadingState::measured, frame.measures.clutter, {}, "whole picture", {}};
    const perception::EdgeView edges{{frame.meter.edges().data(), frame.meter.edges().size()},
                                     static_cast<int>(frame.picture.width),
                                     static_cast<int>(frame.picture.height)};
    std::vector<double> densities(static_cast<std::size_t>(condition.grid.count()));
    static_cast<void>(perception::region_densities(edges, condition.grid, {densities.data(), densities.size()}));
    const int columns = condition.grid.columns;
    const int busiest = static_cast<int>(busiest_region(densities));
    const bool is_every = condition.region == ClutterRegion::every;
    const int column = is_every ? busiest % columns : condition.column, row = is_every ? busiest / columns : condition.row;
    const auto place = static_cast<std::size_t>(row) * static_cast<std::size_t>(columns) + static_cast<std::size_t>(column);
    return region_reading(densities[place], condition.grid, column, row, frame);
}

ContractReading saliency_reading(const ContractCondition& condition, const MeasuredFrame& frame) {
    const std::string& wanted = condition.layer.empty() ? frame.frame.prioritized : condition.layer;
    if (wanted.empty() || is_left_out(condition, wanted)) return {};
    if (!frame.frame.has_scene && (wanted == "data" || wanted == "uncertainty")) return {};
    LayerShare own, all;
    for (const LayerShare& one : frame.measures.layers) {
        if (is_left_out(condition, one.layer)) continue;
        all.share += one.share;
        all.area += one.area;
        if (one.layer == wanted) own = one;
    }
    if (!(all.share > 0)) return {};
    const double share = own.share / all.share, area = own.area / all.area;
    if (condition.measure == ContractMeasure::saliency_share)
        return {ReadingState::measured, share, {}, "whole picture", "of " + wanted};
    return {ReadingState::measured, area > 0 ? share / area : 0, {}, "whole picture", "of " + wanted};
}

ContractReading contrast_reading(const ContractCondition& condition, const MeasuredFrame& frame) {
    const auto layer = static_cast<std::uint8_t>(layer_place(*frame.mask, condition.layer));
    const std::vector<SignContrast> signs =
        sign_contrasts(frame.picture, *frame.mask, layer, static_cast<std::uint32_t>(condition.least_px));
    const auto faintest = std::min_element(signs.begin(), signs.end(),
                                           [](const SignContrast& a, const SignContrast& b) { return a.ratio < b.ratio; });
    if (faintest == signs.end()) return {};
    return {ReadingState::measured,
            faintest->ratio,
            faintest->box,
            third_of(faintest->box, static_cast<int>(frame.picture.width), static_cast<int>(frame.picture.height)),
            {}};
}

ContractReading role_contrast_reading(const ContractCondition& condition, const MeasuredFrame& frame,
                                      const design::SymbologyPalette& palette) {
    const auto layer = static_cast<std::uint8_t>(layer_place(*frame.mask, "symbology"));
    const std::vector<RoleContrast> signs =
        role_contrasts(frame.picture, *frame.mask, layer, palette, static_cast<std::uint32_t>(condition.least_px));
    const auto faintest = std::min_element(signs.begin(), signs.end(),
                                           [](const RoleContrast& a, const RoleContrast& b) { return a.ratio < b.ratio; });
    if (faintest == signs.end()) return {};
    return {ReadingState::measured, faintest->ratio, faintest->box,
            third_of(faintest->box, static_cast<int>(frame.picture.width), static_cast<int>(frame.picture.height)),
            "of " + std::string(design::kSymbolRoleNames[static_cast<std::size_t>(faintest->role)])};
}

ContractReading obstacle_reading(const ContractCondition& condition, const MeasuredFrame& frame) {
    ContractReading worst;
    const double radius_px = condition.focus_share * std::min(frame.picture.width, frame.picture.height);
    std::optional<perception::SalientPlaces> places;
    for (const FrameObstacle& obstacle : *frame.frame.obstacles) {
        if (obstacle.state != "drawn" && obstacle.state != "left_out") continue;
        if (!places) places = places_of(condition, frame);
        const double rank = rank_of(obstacle, *places, radius_px);
        if (worst.state == ReadingState::measured && rank <= worst.value) continue;
        const perception::PixelRegion box = whole_pixels(obstacle);
        worst = {ReadingState::measured, rank, box,
                 third_of(box, static_cast<int>(frame.picture.width), static_cast<int>(frame.picture.height)),
                 obstacle.name + (obstacle.state == "drawn" ? "" : ", which is not shown")};
    }
    return worst;
}

}  // namespace tedavis::host_sim

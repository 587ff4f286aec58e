#include "host_sim/terrain_builder/attributes/attribute_maps.hpp"

#include <algorithm>
#include <cmath>

#include "host_sim/terrain_builder/attributes/direct_light.hpp"
#include "host_sim/terrain_builder/attributes/local_relief.hpp"
#include "host_sim/terrain_builder/attributes/sky_sweep.hpp"
#include "host_sim/terrain_builder/attributes/surface_shape.hpp"

namespace tedavis::host_sim {
namespace {

using terrain::AttributeChannel;
using terrain::kHorizonDirections;
using terrain::kHorizonPostStep;

/// Measures a tile four posts at a time and writes what it finds.
class Surveyor {
public:
    Surveyor(const HeightPlanes& planes, const FixedLight& light, const FarView& above, AttributeFields& fields)
        : planes_(planes),
          light_(light),
          level_light_(static_cast<float>(std::sin(light.elevation_rad))),
          gradients_(planes),
          direct_(direct_light(planes, gradients_, light, above)),
          sky_(planes, gradients_, direct_, level_light_, above),
          fields_(fields) {}

    void run() {
        for (int row = 0; row < fields_.rows; ++row) {
            sky_.begin_row(row);
            for (int column = 0; column < fields_.columns; column += kLanes) survey(column, row);
        }
    }

private:
    void survey(int column, int row) {
        const std::size_t at = planes_.at(column, row);
        SkyLanes sky;
        sky_.sweep(column, sky);
        const NormalLanes normal = normal_of(load(&gradients_.east[at]), load(&gradients_.north[at]));
        const float level = static_cast<float>(light_.direct) * level_light_ + static_cast<float>(light_.sky);
        write(AttributeChannel::normal_east, column, row, normal.east, 0);
        write(AttributeChannel::normal_north, column, row, normal.north, 0);
        write(AttributeChannel::sky_view, column, row, sky.sky_view, 1);
        write(AttributeChannel::curvature, column, row, curvature(planes_, gradients_, at, planes_.east_m(row)), 0);
        write(AttributeChannel::light, column, row, light_on(at, sky), level);
        write(AttributeChannel::openness_above, column, row, sky.openness_above, kHalfPi);
        write(AttributeChannel::aperture_east, column, row, sky.aperture_east, 0);
        write(AttributeChannel::aperture_north, column, row, sky.aperture_north, 0);
        write(AttributeChannel::aperture_radius, column, row, sky.aperture_cosine, 0);
        write(AttributeChannel::openness_below, column, row, sky.openness_below, kHalfPi);
        if (row % kHorizonPostStep == 0) write_horizons(column, row, sky);
    }

    [[nodiscard]] Lanes light_on(std::size_t at, const SkyLanes& sky) const {
        const float direct = static_cast<float>(light_.direct), ambient = static_cast<float>(light_.sky);
        const Lanes returned = direct * sky.bounce + ambient * (1.0f - sky.sky_view);
        return (direct * load(&direct_[at_post][at]) + ambient * sky.sky_view) + static_cast<float>(light_.albedo) * returned;
    }

    void write(AttributeChannel channel, int column, int row, Lanes values, float without_height) {
        const std::size_t at = planes_.at(column, row);
        const int lanes = std::min(kLanes, fields_.columns - column);
        float* const to = &fields_.channel[static_cast<std::size_t>(channel)][index_of(column, row, fields_.columns)];
        const Lanes result = load(&planes_.validity[at]) > 0.0f ? values : all(without_height);
        if (lanes == kLanes) return store(to, result);
        for (int n = 0; n < lanes; ++n) to[n] = result[n];
    }

    void write_horizons(int column, int row, const SkyLanes& sky) {
        const std::size_t at = planes_.at(column, row);
        const Lanes valid = load(&planes_.validity[at]);
        const int lanes = std::min(kLanes, fields_.columns - column);
        const std::size_t to = index_of(column / kHorizonPostStep, row / kHorizonPostStep, fields_.horizon_columns());
        for (std::size_t k = 0; k < kHorizonDirections; ++k) {
            const Lanes tangent = sky.horizon[k], sine = tangent / root(1.0f + tangent * tangent);
            for (int n = 0; n < lanes; n += kHorizonPostStep)
                fields_.horizon_sine[k][to + static_cast<std::size_t>(n / kHorizonPostStep)] = valid[n] > 0 ? sine[n] : 0.0f;
        }
    }

    const HeightPlanes& planes_;
    const FixedLight& light_;
    const float level_light_;
    const Gradients gradients_;
    const HalfPlanes direct_;
    SkySweep sky_;
    AttributeFields& fields_;
};

std::vector<float> class_codes(const AttributeTile& tile) {
    std::vector<float> codes;
    codes.reserve(static_cast<std::size_t>(tile.columns) * static_cast<std::size_t>(tile.rows));
    for (int row = 0; row < tile.rows; ++row) {
        const auto first = tile.post_class.begin() + (row + kAttributeApron) * tile.full_columns() + kAttributeApron;
        for (auto post = first; post != first + tile.columns; ++post) codes.push_back(terrain::class_code(*post));
    }
    return codes;
}

std::uint8_t encode(AttributeChannel channel, float value) {
    switch (channel) {
        case AttributeChannel::normal_east:
        case AttributeChannel::normal_north:
        case AttributeChannel::aperture_east:
        case AttributeChannel::aperture_north: return terrain::encode_signed(value);
        case AttributeChannel::sky_view:
        case AttributeChannel::aperture_radius: return terrain::encode_unit(value);
        case AttributeChannel::curvature: return terrain::encode_signed_root(value);
        case AttributeChannel::light: return terrain::encode_light(value);
        case AttributeChannel::openness_above:
        case AttributeChannel::openness_below: return terrain::encode_openness(value);
        case AttributeChannel::local_relief: return terrain::encode_relief(value);
        case AttributeChannel::post_class: break;
    }
    return static_cast<std::uint8_t>(value);
}

}  // namespace

AttributeFields measure_attributes(const HeightPlanes& planes, const FixedLight& light, const FarView& above) {
    AttributeFields fields;
    fields.columns = planes.tile.columns;
    fields.rows = planes.tile.rows;
    const std::size_t posts = static_cast<std::size_t>(fields.columns) * static_cast<std::size_t>(fields.rows);
    for (std::vector<float>& channel : fields.channel) channel.resize(posts);
    const std::size_t horizons =
        static_cast<std::size_t>(fields.horizon_columns()) * static_cast<std::size_t>(fields.horizon_rows());
    for (std::vector<float>& plane : fields.horizon_sine) plane.resize(horizons);
    Surveyor(planes, light, above, fields).run();
    fields.channel[static_cast<std::size_t>(AttributeChannel::local_relief)] = local_relief_m(planes.tile);
    fields.channel[static_cast<std::size_t>(AttributeChannel::post_class)] = class_codes(planes.tile);
    return fields;
}

AttributeMaps encode_attributes(const AttributeFields& fields) {
    AttributeMaps maps;
    maps.columns = fields.columns;
    maps.rows = fields.rows;
    const std::size_t posts = fields.channel.front().size();
    for (auto& map : maps.rgba) map.resize(4 * posts);
    for (std::size_t c = 0; c < terrain::kAttributeChannels; ++c) {
        std::uint8_t* const to = maps.rgba[c / 4].data() + c % 4;
        for (std::size_t n = 0; n < posts; ++n) to[4 * n] = encode(static_cast<AttributeChannel>(c), fields.channel[c][n]);
    }
    for (std::size_t k = 0; k < kHorizonDirections; ++k)
        for (const float sine : fields.horizon_sine[k]) maps.horizon[k].push_back(terrain::encode_horizon(sine));
    return maps;
}

TileAttributes make_attributes(const AttributeTile& tile, const FixedLight& light, const FarView& above,
                               bool level_below_follows) {
    const HeightPlanes planes(tile);
    TileAttributes made;
    made.maps = encode_attributes(measure_attributes(planes, light, above));
    if (level_below_follows) made.far = make_far_horizons(planes, above);
    return made;
}

}  // namespace tedavis::host_sim

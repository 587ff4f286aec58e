#include "render_core/design/focus_settings.hpp"

#include <algorithm>

#include "render_core/base/units.hpp"
#include "render_core/design/config_values.hpp"
#include "render_core/design/view_effects.hpp"

namespace tedavis::design {
namespace {

using base::ConfigSection;

constexpr double kLargestValue = 1e12;

template <std::size_t N>
void read_name(ConfigSection& section, std::string_view key, base::FixedString<N>& name) {
    name = section.text(key, "");
    if (name.cut()) fault_of(section, key, "is too long; at most 23 bytes, of a layer or attribute 31");
}

void refuse(ConfigSection& section, std::string_view key, bool is_meant, std::string_view what) {
    if (section.has(key) && !is_meant) fault_of(section, key, what);
}

void require(ConfigSection& section, std::string_view key, bool is_needed, std::string_view what) {
    if (is_needed && !section.has(key)) fault_of(section, key, what);
}

void read_place(ConfigSection& section, FocusSettings& focus) {
    read_name(section, "place", focus.place);
    const bool is_named = focus.at == FocusAt::place || focus.at == FocusAt::destination;
    refuse(section, "place", is_named, "is for at = \"place\" and at = \"destination\"; leave it out");
    require(section, "place", focus.at == FocusAt::place, "is missing: which feature of the scene; state its name");
    double at_deg[2]{};
    section.numbers("position_deg", -180, 180, at_deg);
    if (at_deg[0] < -90 || at_deg[0] > 90) fault_of(section, "position_deg", "is latitude, then longitude");
    refuse(section, "position_deg", focus.at == FocusAt::position, "is for at = \"position\"; leave it out");
    require(section, "position_deg", focus.at == FocusAt::position, "is missing; state [latitude, longitude]");
    focus.latitude_rad = base::radians(at_deg[0]);
    focus.longitude_rad = base::radians(at_deg[1]);
    focus.ahead_s = section.number("ahead_s", 10, 7200, focus.ahead_s);
    refuse(section, "ahead_s", focus.at == FocusAt::flight_path, "is for at = \"flight_path\"; leave it out");
}

void read_space(ConfigSection& section, FocusSettings& focus) {
    const bool is_path = focus.shape == FocusShape::path;
    if (is_path) focus.at = FocusAt::flight_path;
    section.choose("at", kFocusAtNames, focus.at);
    if (is_path != (focus.at == FocusAt::flight_path))
        fault_of(section, "at", "and 'shape' do not fit: a path is at = \"flight_path\", and that is of no other shape");
    read_place(section, focus);
    focus.has_height = section.has("height_m");
    focus.height_m = section.number("height_m", -1000, 100'000, 0);
    refuse(section, "height_m", focus.shape == FocusShape::sphere, "is of a sphere's middle; leave it out");
    focus.lower_m = section.number("lower_m", -1000, 100'000, 0);
    focus.upper_m = section.number("upper_m", -1000, 100'000, 0);
    for (const std::string_view key : {"lower_m", "upper_m"}) {
        refuse(section, key, focus.shape == FocusShape::cuboid, "is of a cuboid; leave it out");
        require(section, key, focus.shape == FocusShape::cuboid, "is missing: a cuboid reaches from 'lower_m' to 'upper_m'");
    }
    if (focus.shape == FocusShape::cuboid && focus.lower_m >= focus.upper_m)
        fault_of(section, "upper_m", "must be higher than 'lower_m'");
    for (const std::string_view key : {"layer", "role", "attribute", "value", "interval", "extreme", "within", "similar"})
        refuse(section, key, false, "is for shape = \"data\"; leave it out");
}

void read_values(ConfigSection& section, FocusOfData& data) {
    constexpr std::string_view kExtremes[] = {"highest", "lowest"};
    const bool has_value = section.has("value"), has_interval = section.has("interval"), has_extreme = section.has("extreme");
    if (int{has_value} + int{has_interval} + int{has_extreme} != 1)
        return fault_of(section, "value", "or 'interval' or 'extreme' says which values are meant; give one of them");
    data.within = section.number("within", 0, kLargestValue, 0);
    data.similar = section.number("similar", 0, kLargestValue, 0);
    refuse(section, "within", !has_interval, "is of 'value' and 'extreme'; an interval says itself what is in it");
    section.choose("extreme", kExtremes, data.values, FocusValues::highest);
    double ends[2]{};
    if (has_interval) section.numbers("interval", -kLargestValue, kLargestValue, ends);
    if (has_value) {
        const double value = section.number("value", -kLargestValue, kLargestValue, 0);
        ends[0] = value - data.within;
        ends[1] = value + data.within;
    }
    if (ends[0] > ends[1]) fault_of(section, "interval", "goes from the lower to the higher value");
    data.low = ends[0];
    data.high = ends[1];
}

void read_data_focus(ConfigSection& section, FocusSettings& focus) {
    read_name(section, "layer", focus.data.layer);
    if (section.has("layer") == section.has("role"))
        return fault_of(section, "layer", "or 'role' says which data are meant; give one of them");
    section.choose("role", scene::kLayerRoleNames, focus.data.role);
    focus.data.attribute = section.text("attribute");
    if (focus.data.attribute.cut()) fault_of(section, "attribute", "is longer than 31 bytes; no attribute has such a name");
    read_values(section, focus.data);
    for (const std::string_view key : {"at", "place", "position_deg", "ahead_s", "height_m", "lower_m", "upper_m"})
        refuse(section, key, false, "is for a focus of space, and this one is where the data are; leave it out");
}

void read_context(ConfigSection section, FocusSettings& focus) {
    const bool is_square = focus.shape == FocusShape::square || focus.shape == FocusShape::cuboid;
    if (is_square) focus.context.distance = scene::FocusDistance::chebyshev;
    section.choose("distance", scene::kFocusDistanceNames, focus.context.distance);
    focus.context.width_m = section.number("width_m", 0, 500'000, focus.context.width_m);
    focus.context.levels = static_cast<std::uint32_t>(section.integer("levels", 0, 16, focus.context.levels));
}

void read_look(ConfigSection ground, ConfigSection data, FocusSettings& focus) {
    FocusTerrain& terrain = focus.terrain;
    terrain.sketch_outside = ground.boolean("sketch_outside", terrain.sketch_outside);
    terrain.brightness = ground.number("brightness", 0, 1, terrain.brightness);
    terrain.saturation = ground.number("saturation", 0, 1, terrain.saturation);
    terrain.blur_px = ground.number("blur_px", 0, kMaxBlur_px, terrain.blur_px);
    FocusData& look = focus.of_data;
    look.detail = data.number("detail", 0, 1, look.detail);
    look.brightness = data.number("brightness", 0.2, 1, look.brightness);
    look.saturation = data.number("saturation", 0, 1, look.saturation);
    look.size = data.number("size", 0.2, 1, look.size);
    look.aggregate = static_cast<std::uint32_t>(data.integer("aggregate", 1, 16, look.aggregate));
    data.choose("context", kFocusContextDataNames, look.context);
}

void read_border(ConfigSection section, FocusBorder& border) {
    section.choose("kind", kFocusBorderNames, border.kind);
    read_color(section, "color", border.color);
    border.width_px = section.number("width_px", 0.5, 20, border.width_px);
}

FocusSettings read_one(ConfigSection section) {
    FocusSettings focus;
    read_name(section, "name", focus.name);
    section.choose("shape", kFocusShapeNames, focus.shape);
    focus.radius_m = section.number("radius_m", 10, 200'000, focus.radius_m);
    if (focus.shape == FocusShape::data)
        read_data_focus(section, focus);
    else
        read_space(section, focus);
    read_context(section.section("context"), focus);
    read_look(section.section("terrain"), section.section("data"), focus);
    read_border(section.section("border"), focus.border);
    focus.power = static_cast<std::uint32_t>(section.section("distortion").integer("power", 0, kMaxFocusPower, 0));
    if (focus.name.empty()) focus.name = kFocusShapeNames[static_cast<std::size_t>(focus.shape)];
    return focus;
}

void refuse_second_context(ConfigSection& root, const FocusList& foci) {
    for (const std::string_view key : {"terrain", "data"}) {
        std::size_t count = 0;
        for (std::size_t n = 0; n < foci.size(); ++n) {
            ConfigSection focus = root.table_at("focus", n);
            if (focus.has(key) && ++count > 1)
                fault_of(focus, key,
                         "is stated twice; the context is common to all foci, so one of them says what it looks like");
        }
    }
}

}  // namespace

const FocusTerrain& terrain_of_context(const FocusList& foci) noexcept {
    static constexpr FocusTerrain kAsItIs;
    for (const FocusSettings& focus : foci)
        if (focus.terrain.is_any()) return focus.terrain;
    return kAsItIs;
}

const FocusData& data_of_context(const FocusList& foci) noexcept {
    static constexpr FocusData kAsTheyAre;
    for (const FocusSettings& focus : foci)
        if (focus.of_data.is_any()) return focus.of_data;
    return kAsTheyAre;
}

bool change_the_ground(const FocusList& foci) noexcept {
    return std::any_of(foci.begin(), foci.end(), [](const FocusSettings& focus) {
        return focus.terrain.is_any() || focus.border.kind != FocusBorderKind::none;
    });
}

FocusTerrain darkened_instead_of_blurred(FocusTerrain look) noexcept {
    if (look.blur_px > 0) look.brightness *= kBlurAsBrightness;
    look.blur_px = 0;
    return look;
}

void read_foci(ConfigSection& root, FocusList& foci) {
    const std::size_t count = root.table_count("focus");
    foci.clear();
    for (std::size_t n = 0; n < count; ++n)
        if (!foci.try_push_back(read_one(root.table_at("focus", n))))
            return fault_of(root, "focus", "is more often there than a display has room for; keep at most 4");
    refuse_second_context(root, foci);
}

base::Result<FocusSettings, base::Error> read_focus(std::string_view line) {
    base::FixedString<1023> text("focus = [{");
    text.append(line);
    text.append("}]");
    if (text.cut()) return base::fail(base::Error{"--focus: is longer than a thousand bytes; leave something out"});
    base::ConfigReader reader(text.view(), "--focus");
    ConfigSection root = reader.root();
    FocusList foci;
    read_foci(root, foci);
    if (!reader.finish()) return base::fail(reader.error());
    if (foci.size() != 1) return base::fail(base::Error{"--focus: states more than one; give the option for each"});
    return foci[0];
}

}  // namespace tedavis::design

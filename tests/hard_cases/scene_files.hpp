/// Files of spatial data as a user hands them over, built by the program into a scene database, and what a display draws of it:
/// level ground 500 m high at 36.71 N 84.21 W, seen from 5 km above its middle.
///
/// Degrees are dyadic numbers, so that files that say the same in another order or over another turn say it to the last bit.
#pragma once

#include <cmath>
#include <memory>
#include <optional>
#include <string>

#include "host_sim/replay/load_design.hpp"
#include "platform/files/file_byte_source.hpp"
#include "tests/support/draw/ground_drawing.hpp"
#include "tests/support/files/raster_file.hpp"
#include "tests/support/files/temporary_folder.hpp"
#include "tests/support/programs/program_words.hpp"
#include "tests/support/scene/map_scene.hpp"

namespace tedavis::test_support {

struct DataSite {
    static constexpr double kWest_deg = -84.25, kNorth_deg = 36.75, kStep_deg = 1.0 / 1024, kGround_m = 500, kEye_m = 5500;
    static constexpr std::uint32_t kPosts = 81, kMiddle = 40;
    static constexpr double kLatitude_deg = kNorth_deg - kMiddle * kStep_deg, kLongitude_deg = kWest_deg + kMiddle * kStep_deg;

    static const RasterScene& ground() {
        static const RasterScene scene(make_raster(
            kPosts, kPosts, [](std::uint32_t, std::uint32_t) { return kGround_m; }, kWest_deg, kNorth_deg, kStep_deg));
        return scene;
    }
    static terrain::View from_above() { return ground().view(kMiddle, kMiddle, kEye_m, 0, -90); }
    /// Where pixels of a picture from above look at, row by row.
    static const std::vector<earth::Geodetic>& places_from_above() {
        static const std::vector<earth::Geodetic> places = [] {
            const terrain::View view = from_above();
            const double ellipsoid_m = ground().place(kMiddle, kMiddle, kGround_m).height.m;
            std::vector<earth::Geodetic> all;
            for (std::uint32_t y = 0; y < view.height; ++y)
                for (std::uint32_t x = 0; x < view.width; ++x)
                    all.push_back(place_of(view, static_cast<int>(x), static_cast<int>(y), ellipsoid_m));
            return all;
        }();
        return places;
    }
};

/// 8 x 8 pixels over the middle of the site, and ground on every side of them.
inline RasterFile site_raster() {
    RasterFile raster;
    raster.columns = raster.rows = 8;
    raster.transform = {DataSite::kWest_deg + 1.0 / 128, 1.0 / 128, 0, DataSite::kNorth_deg - 1.0 / 128, 0, -1.0 / 128};
    raster.value = [](int i, int j) { return 10 + 9.0 * i + 2.0 * j; };
    return raster;
}

/// Of a picture, with what its record says.
struct DataPicture {
    HillsPicture picture;
    display::FrameRecord record;

    [[nodiscard]] design::Color at(std::uint32_t x, std::uint32_t y) const {
        const std::uint8_t* const p = picture.at(x, y);
        return {p[0], p[1], p[2]};
    }
    [[nodiscard]] std::size_t count(design::Color color) const {
        std::size_t n = 0;
        for (std::uint32_t y = 0; y < picture.height; ++y)
            for (std::uint32_t x = 0; x < picture.width; ++x) n += at(x, y) == color ? 1 : 0;
        return n;
    }
    [[nodiscard]] std::size_t differing(const DataPicture& other) const {
        std::size_t n = 0;
        for (std::uint32_t y = 0; y < picture.height; ++y)
            for (std::uint32_t x = 0; x < picture.width; ++x) n += at(x, y) == other.at(x, y) ? 0 : 1;
        return n;
    }
    /// Of any channel of any pixel.
    [[nodiscard]] int most_difference(const DataPicture& other) const {
        int most = 0;
        for (std::uint32_t y = 0; y < picture.height; ++y)
            for (std::uint32_t x = 0; x < picture.width; ++x) most = std::max(most, color_difference(at(x, y), other.at(x, y)));
        return most;
    }
    /// Without a name where the record has none of it.
    [[nodiscard]] display::EffectRecord effect(std::string_view name) const {
        for (const display::EffectRecord& effect : record.effects)
            if (effect.name.view() == name) return effect;
        return {};
    }
};
inline bool operator==(const DataPicture& a, const DataPicture& b) { return a.picture == b.picture; }
inline bool operator!=(const DataPicture& a, const DataPicture& b) { return !(a == b); }
/// For failures: no pixels.
inline void PrintTo(const DataPicture& picture, std::ostream* out) {
    *out << "a picture with " << picture.record.data.size() << " types of data";
}

/// Level ground of one colour (kBareGround), without light, haze and warnings; `data`: the tables of the data on it. Palette
/// "scale.toml": greens() from 0 to 100.
inline std::string plain_ground_design(const std::string& data) {
    return "name = 'test'\n[terrain.texture]\ntechnique = 'plain'\nplain_color = '#c8beaa'\n[terrain.shade]\ntechnique = 'none'\n"
           "[sky]\nhaze_distance_m = 0\n[warning]\nenabled = false\n" +
           data;
}

class SceneFiles {
public:
    explicit SceneFiles(std::string device = "es2-small") : device_(std::move(device)) {
        (void)folder_.write("scale.toml",
                            "name = 'scale'\ntitle = 'SCALE'\nkind = 'sequential'\nunit = '1'\norder = 'lightness'\n"
                            "purpose = 'data'\n[[stop]]\nvalue = 0\ncolor = '#f0fae6'\n[[stop]]\nvalue = 40\n"
                            "color = '#78be8c'\n[[stop]]\nvalue = 100\ncolor = '#0a3c32'\n");
    }

    [[nodiscard]] const TemporaryFolder& folder() const { return folder_; }
    void write(const RasterFile& raster, const std::string& name = "grid.tif") const { (void)raster.write(folder_.file(name)); }
    void write(const std::string& text, const std::string& name) const { (void)folder_.write(name, text); }

    /// `layers`: the tables [[layer]] of the scene file.
    ProgramOutcome build(const std::string& layers) {
        std::filesystem::remove(database());
        (void)folder_.write("s.toml", "name = 'bad'\norigin = 'made for a test'\n" + layers);
        return run_words({"scene", "build", folder_.file("s.toml"), "-o", database()});
    }
    [[nodiscard]] std::string database() const { return folder_.file("s.sdb"); }
    [[nodiscard]] bool has_database() const { return std::filesystem::exists(database()); }

    /// What was built last, in a design, without any symbols.
    [[nodiscard]] DataPicture draw(const std::string& design_text, const terrain::View& view = DataSite::from_above()) const {
        return draw(without_symbols(design_of(design_text)), DataSite::kLatitude_deg, &view, view.width, view.height);
    }
    /// The same from an aircraft south of the site that flies to the north, with the legend, for which there is room.
    [[nodiscard]] DataPicture draw_with_legend(const std::string& design_text) const {
        design::DesignSettings design = without_symbols(design_of(design_text));
        design.symbology.legend = true;
        return draw(design, DataSite::kLatitude_deg - 0.03, nullptr, 640, 480);
    }
    /// Built and drawn; whatever the build notes is in `notes`.
    [[nodiscard]] DataPicture drawn(const std::string& layers, const std::string& design_text,
                                    const terrain::View& view = DataSite::from_above()) {
        const ProgramOutcome built = build(layers);
        EXPECT_EQ(built.code, 0) << built.notes;
        notes_ = built.notes;
        return draw(design_text, view);
    }
    [[nodiscard]] const std::string& notes() const { return notes_; }

private:
    [[nodiscard]] design::DesignSettings design_of(const std::string& text) const {
        host_sim::PictureOptions options;
        options.design = folder_.write("design.toml", text);
        return host_sim::load_design(options);
    }
    /// `view`: null for the aircraft's own.
    [[nodiscard]] DataPicture draw(const design::DesignSettings& design, double latitude_deg, const terrain::View* view,
                                   std::uint32_t width, std::uint32_t height) const {
        auto file = platform::open_file(database().c_str());
        EXPECT_TRUE(file.ok()) << "no database was built";
        MemoryBytes terrain(DataSite::ground().built.image);
        HeadlessDisplay headless("egl", device_, width, height, &terrain, design, as_it_is, &file.value());
        if (view != nullptr) headless.display().planner().set_free_view(*view);
        const flight::AircraftState state = aircraft_on_map({latitude_deg, DataSite::kLongitude_deg}, 0, 0, 2000);
        DataPicture drawn{{settled_pixels(headless, state, kHillsNow), width, height}, {}};
        drawn.record = headless.display().record();
        return drawn;
    }

    TemporaryFolder folder_;
    std::string device_, notes_;
};

}  // namespace tedavis::test_support

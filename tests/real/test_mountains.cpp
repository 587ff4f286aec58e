// A recorded flight over the Alps shows the right mountains: summits read from the picture lie where geodesy puts them.
#include <gtest/gtest.h>

#include <GeographicLib/LocalCartesian.hpp>
#include <cmath>
#include <sstream>

#include "host_sim/commands/convert.hpp"
#include "host_sim/replay/flight_player.hpp"
#include "tests/support/files/paths.hpp"
#include "tests/support/files/temporary_folder.hpp"
#include "tests/support/terrain/skyline.hpp"
#include "tests/support/terrain/terrain_image.hpp"

namespace tedavis::test_mountains {
namespace {

using test_support::SkylinePicture;

constexpr double kTolerance_deg = 0.1;

struct Direction {
    double bearing_deg, elevation_deg;
};

bool agree(const Direction& a, const Direction& b) {
    return std::abs(std::remainder(a.bearing_deg - b.bearing_deg, 360)) <= kTolerance_deg &&
           std::abs(a.elevation_deg - b.elevation_deg) <= kTolerance_deg;
}

/// Bearing and elevation in the local frame below the eye.
class Observer {
public:
    Observer(double lat_deg, double lon_deg, double ellipsoid_m) : local_(lat_deg, lon_deg, ellipsoid_m) {}
    [[nodiscard]] Direction to(double lat_deg, double lon_deg, double ellipsoid_m) const {
        double x = 0, y = 0, z = 0;
        local_.Forward(lat_deg, lon_deg, ellipsoid_m, x, y, z);
        return {base::degrees(std::atan2(x, y)), base::degrees(std::atan2(z, std::hypot(x, y)))};
    }
    [[nodiscard]] Direction along(const glm::dvec3& eye, const glm::dvec3& ray) const {
        double lat = 0, lon = 0, height = 0;
        const glm::dvec3 p = eye + ray * 1000.0;
        GeographicLib::Geocentric::WGS84().Reverse(p.x, p.y, p.z, lat, lon, height);
        return to(lat, lon, height);
    }

private:
    GeographicLib::LocalCartesian local_;
};

/// Tops of the skyline that drop by at least three pixels on both sides within twelve columns, as directions.
std::vector<Direction> summits_of_picture(const SkylinePicture& picture, const test_support::OracleCamera& camera,
                                          const Observer& observer) {
    constexpr int kReach = 12, kDrop_px = 3;
    std::vector<Direction> summits;
    const auto row = [&](int column) { return picture.skyline_px(column).value_or(static_cast<int>(camera.height)); };
    for (int column = kReach; column < static_cast<int>(camera.width) - kReach; ++column) {
        const int top = row(column);
        int right_end = column;  // of the level stretch that starts here
        while (right_end < static_cast<int>(camera.width) - kReach && row(right_end + 1) == top) ++right_end;
        bool is_top = row(column - 1) > top && row(right_end + 1) > top && right_end - column <= 3;
        int left_drop = 0, right_drop = 0;
        for (int n = 1; n <= kReach; ++n) {
            is_top = is_top && row(column - n) > top && row(right_end + n) > top;
            left_drop = std::max(left_drop, row(column - n) - top);
            right_drop = std::max(right_drop, row(right_end + n) - top);
        }
        if (is_top && left_drop >= kDrop_px && right_drop >= kDrop_px)
            summits.push_back(observer.along(camera.eye, camera.ray(0.5 * (column + right_end) + 0.5, top + 0.5)));
        column = right_end;
    }
    return summits;
}

/// Posts that are the highest within 15 posts, as directions.
std::vector<Direction> summits_of_raster(const host_sim::Raster& raster, const Observer& observer) {
    constexpr std::uint32_t kReach = 15;
    const host_sim::GeoidEgm96 geoid = host_sim::GeoidEgm96::installed();
    std::vector<Direction> summits;
    for (std::uint32_t j = kReach; j + kReach < raster.rows; ++j)
        for (std::uint32_t i = kReach; i + kReach < raster.columns; ++i) {
            const float height = raster.height_m[raster.at(i, j)];
            bool highest = height > 2200;
            for (std::uint32_t b = j - kReach; highest && b <= j + kReach; ++b)
                for (std::uint32_t a = i - kReach; highest && a <= i + kReach; ++a)
                    highest = raster.height_m[raster.at(a, b)] <= height;
            if (!highest) continue;
            const double lat = raster.north_deg - j * raster.step_lat_deg, lon = raster.west_deg + i * raster.step_lon_deg;
            summits.push_back(observer.to(lat, lon, double{height} + geoid.undulation(base::radians(lat), base::radians(lon)).m));
        }
    return summits;
}

int matched(const std::vector<Direction>& seen, const std::vector<Direction>& known, double turned_deg = 0) {
    return static_cast<int>(std::count_if(seen.begin(), seen.end(), [&](Direction s) {
        s.bearing_deg += turned_deg;
        return std::any_of(known.begin(), known.end(), [&](const Direction& k) { return agree(s, k); });
    }));
}

TEST(Mountains, OfAFlightOverDavosLieWhereGeodesyPutsThem) {
    const std::string data = test_support::real_data_dir();
    const test_support::TemporaryFolder folder;
    std::ostringstream results, notes;
    host_sim::Console console(results, notes, false, false);
    host_sim::ConvertOptions convert;
    convert.flight = data + "/flights/adsb_switzerland_map.json.gz";
    convert.aircraft = "4b1c22";
    convert.output = folder.path() + "/flight.log";
    ASSERT_EQ(host_sim::run_convert(convert, console), 0) << notes.str();

    const host_sim::Raster raster =
        host_sim::load_rasters({data + "/terrain/davos_engadin_srtm1_1arcsec_2160x2160_wgs84.tif"}, {});
    const std::vector<std::uint8_t> image = test_support::build_image(raster);
    test_support::MemoryBytes terrain(image);
    test_support::HeadlessDisplay headless("egl", "desktop", 1024, 768, &terrain, test_support::garish_design());
    host_sim::FlightPlayer player({convert.output, "canaerospace", "", "one_hot"}, headless.display());

    int found = 0, by_chance = 0;
    for (const double second : {10755.0, 10770.0, 10785.0, 10800.0}) {  // while it crosses the raster northbound
        const base::Time now = player.first() + base::Duration::from_seconds(second);
        const SkylinePicture picture(headless, player.at(now).state, now);
        ASSERT_GT(picture.record().terrain.triangles, 0u) << second;
        const test_support::OracleCamera camera = picture.camera();
        double lat = 0, lon = 0, height = 0;
        GeographicLib::Geocentric::WGS84().Reverse(camera.eye.x, camera.eye.y, camera.eye.z, lat, lon, height);
        const Observer observer(lat, lon, height);
        const auto seen = summits_of_picture(picture, camera, observer), known = summits_of_raster(raster, observer);
        found = std::max(found, matched(seen, known));
        by_chance = std::max(by_chance, matched(seen, known, 0.7));
    }
    EXPECT_GE(found, 3) << "summits in one picture that are a local maximum of the raster to 0.1 degrees";
    EXPECT_LT(by_chance, 3) << "control: turned by 0.7 degrees they must not match";
    RecordProperty("found", found);
    RecordProperty("by_chance", by_chance);
}

}  // namespace
}  // namespace tedavis::test_mountains

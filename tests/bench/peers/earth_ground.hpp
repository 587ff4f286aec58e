/// The same posts as our terrain database has them: on the WGS84 ellipsoid plus undulation, round the place at 0 N 0 E, where
/// steps of longitude and of latitude make cells of 30 m x 30 m.
#pragma once

#include "platform/files/file_byte_source.hpp"
#include "render_core/earth/wgs84.hpp"
#include "render_core/terrain/terrain_database.hpp"
#include "tests/bench/peers/flat_ground.hpp"

namespace tedavis::peers {

/// Of the middle post's surroundings at 0 N 0 E: radians a metre.
inline double latitude_per_m() { return 1 / earth::meridian_radius_m(0); }
inline double longitude_per_m() { return 1 / earth::kSemiMajorAxis_m; }

/// A database, opened on a file.
class OpenedDatabase {
public:
    explicit OpenedDatabase(const std::string& file) : source_(platform::open_file(file.c_str())), memory_(1u << 22) {
        if (!source_.ok()) throw std::runtime_error(source_.error().message.c_str());
        base::Arena arena(memory_.data(), memory_.size() * 8);
        auto opened = terrain::TerrainDatabase::open(source_.value(), arena);
        if (!opened.ok()) throw std::runtime_error(file + " is no terrain database");
        database_ = opened.value();
        if (database_.lattice().columns() != kSide || database_.lattice().rows() != kSide)
            throw std::runtime_error(file + " has other posts than the raster");
    }
    OpenedDatabase(const OpenedDatabase&) = delete;
    OpenedDatabase& operator=(const OpenedDatabase&) = delete;
    [[nodiscard]] const terrain::TerrainDatabase& database() const { return database_; }
    [[nodiscard]] base::ByteSource& source() { return source_.value(); }

private:
    base::Result<platform::FileByteSource, base::Error> source_;
    std::vector<std::uint64_t> memory_;
    terrain::TerrainDatabase database_;
};

/// A pose of the flat frame on the Earth: heights are above mean sea level, axes those of east, north and up at the eye.
struct EarthPose {
    earth::Ecef eye;
    glm::dmat3 east_north_up;

    EarthPose(const terrain::TerrainDatabase& database, const Pose& pose) {
        const double latitude = (pose.y_m - 0.5 * kExtent_m) * latitude_per_m();
        const double longitude = (pose.x_m - 0.5 * kExtent_m) * longitude_per_m();
        eye = earth::to_ecef({latitude, longitude, earth::to_ellipsoid({pose.z_m}, database.undulation(latitude, longitude))});
        const glm::dmat3 north_east_down = earth::north_east_down(latitude, longitude);
        east_north_up = {north_east_down[1], north_east_down[0], -north_east_down[2]};
    }
};

class EarthGround {
public:
    /// `ground` has the same posts and must outlive it.
    EarthGround(const std::string& file, const FlatGround& ground) : opened_(file), ground_(ground) {}

    void look(const Pose& pose) { pose_ = std::make_unique<EarthPose>(opened_.database(), pose); }
    /// Of a place relative to the eye, east, north, up: how far it lies above the surface, and the vertical there, in the same
    /// axes. False near the raster's border.
    [[nodiscard]] bool above(const glm::dvec3& relative_m, double& above_m, glm::dvec3& up) const {
        const earth::Geodetic place = earth::from_ecef(pose_->eye + pose_->east_north_up * relative_m);
        const terrain::LatticePoint at = opened_.database().lattice().point(place.latitude_rad, place.longitude_rad);
        if (!FlatGround::is_inside(at.i, at.j)) return false;
        const double msl_m =
            earth::to_msl(place.height, opened_.database().undulation(place.latitude_rad, place.longitude_rad)).m;
        above_m = ground_.above_m(at.i, at.j, msl_m, Diagonal::north_east);
        up = glm::transpose(pose_->east_north_up) * -earth::north_east_down(place.latitude_rad, place.longitude_rad)[2];
        return true;
    }

private:
    OpenedDatabase opened_;
    const FlatGround& ground_;
    std::unique_ptr<EarthPose> pose_;
};

}  // namespace tedavis::peers

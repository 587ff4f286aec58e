/// The scene of a display: spatial data in memory, and what of it colours the ground now.
///
///   start(...) · plan(design, time) each frame, without GL · ground() and ground_key() for the painter
///
/// Time      data follow the flight's time where it is a date; where it is none (a board whose bus states no UTC) they stand at
///           their own first time. Slices are of whole minutes, so that the same moment shows the same picture.
/// Memory    the arenas given to start(). Thread  the display's. Failure  start() gives one sentence.
#pragma once

#include "render_core/base/error.hpp"
#include "render_core/base/ports/byte_source.hpp"
#include "render_core/design/data_style.hpp"
#include "render_core/flight/flight_time.hpp"
#include "render_core/scene/grid_slice.hpp"

namespace tedavis::display {

enum class GroundDataState : std::uint8_t {
    not_asked_for,
    no_terrain,
    no_scene,
    no_such_layer,
    no_such_attribute,
    too_large,    ///< the layer is no grid, or has more posts than the device has room for
    no_classes,   ///< the palette is of classes, and the attribute has none
    no_members,   ///< the attribute is no ensemble whose members the scene holds
    out_of_date,  ///< the data's validity has ended, or has not begun
    shown,
};
/// Whether a layer's data are valid at a time.
[[nodiscard]] bool is_valid_at(const scene::Layer& layer, std::int64_t time_ns) noexcept;
/// Returns the height that a design requests, else the lowest level.
[[nodiscard]] double height_or_lowest_m(double height_m, const scene::Layer& layer) noexcept;
/// For records: "the scene has no such layer".
[[nodiscard]] const char* reason_of(GroundDataState state) noexcept;

struct SpatialDataPlan {
    GroundDataState ground = GroundDataState::not_asked_for;
    std::uint32_t member = scene::kMean;  ///< the member of the ensemble that colours the ground
    std::uint32_t members = 0;            ///< members that do so one after the other
};

/// Returns the part of a message of start() that concerns the scene database, to follow the file's name; empty for other
/// messages.
[[nodiscard]] std::string_view scene_fault(std::string_view message) noexcept;

class SpatialData {
public:
    struct Memory {
        base::Arena &scene, &slices;
    };
    /// Returns the bytes of the budget line scene_data that suffice for a file of so many bytes, and for a next one of this size.
    [[nodiscard]] static std::uint64_t scene_bytes(std::uint64_t file_bytes) noexcept;
    /// `file`: null for no scene. `most_side`: posts across and down that the ground's map has room for; 0
    /// without terrain.
    [[nodiscard]] base::Error start(base::ByteSource* file, const Memory& memory, std::uint32_t most_side);
    [[nodiscard]] bool has_scene() const { return has_scene_; }
    /// Returns empty memory for the next scene: half of the arena given to start(); the other half holds the scene that is shown.
    [[nodiscard]] base::Arena& spare();
    /// Whether a scene has a larger revision than the one that is shown.
    [[nodiscard]] bool is_newer(const scene::Scene& scene) const {
        return !has_scene_ || scene.header().revision > scene_.header().revision;
    }
    /// Shows a scene that was loaded into spare(), from the next plan() on. Returns false and changes nothing unless its revision
    /// is larger.
    [[nodiscard]] bool take(const scene::Scene& scene);
    [[nodiscard]] const scene::Scene& scene() const { return scene_; }

    /// Plans what colours the ground from now on, or states why nothing does.
    [[nodiscard]] SpatialDataPlan plan(const design::DataStyle& design, const flight::FlightTime& time);
    /// Returns a number that changes when the texels of the ground change, appear or disappear; 0 before the first.
    [[nodiscard]] std::uint64_t ground_key() const { return ground_key_; }
    /// Returns what colours the ground; null for nothing.
    [[nodiscard]] const scene::GridSlice* ground() const { return is_shown_ ? &slice_ : nullptr; }

private:
    [[nodiscard]] GroundDataState choose(const design::GroundData& ground);
    [[nodiscard]] scene::SliceMoment moment_at(const flight::FlightTime& time, const design::GroundData& ground) const;
    [[nodiscard]] std::uint32_t members_shown(const design::GroundData& ground) const;
    void prepare_next(const flight::FlightTime& time, const design::GroundData& ground);
    void show(bool shown);

    base::Arena rooms_[2];
    std::size_t room_ = 0;  ///< of the scene that is shown
    scene::Scene scene_;
    scene::GridSlice slice_;
    std::uint32_t most_side_ = 0;
    bool has_scene_ = false, is_shown_ = false;
    std::uint64_t ground_key_ = 0;
};

}  // namespace tedavis::display

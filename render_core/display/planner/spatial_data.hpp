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
/// Whether a layer's data hold at a time.
[[nodiscard]] bool is_valid_at(const scene::Layer& layer, std::int64_t time_ns) noexcept;
/// The height that a design asks for, else the lowest level.
[[nodiscard]] double height_or_lowest_m(double height_m, const scene::Layer& layer) noexcept;
/// For records: "the scene has no such layer".
[[nodiscard]] const char* reason_of(GroundDataState state) noexcept;

struct SpatialDataPlan {
    GroundDataState ground = GroundDataState::not_asked_for;
    std::uint32_t member = scene::kMean;  ///< of the ensemble, that colours the ground
    std::uint32_t members = 0;            ///< that do so one after the other
};

/// What a sentence of start() says of the scene database, to stand behind the file's name; empty for one about other things.
[[nodiscard]] std::string_view scene_fault(std::string_view message) noexcept;

class SpatialData {
public:
    struct Memory {
        base::Arena &scene, &slices;
    };
    /// Bytes of the budget line scene_data that surely hold a file of so many bytes, and the next one of this size.
    [[nodiscard]] static std::uint64_t scene_bytes(std::uint64_t file_bytes) noexcept;
    /// `file`: null for no scene. `most_side`: posts across and down that the ground's map has room for; 0
    /// without terrain.
    [[nodiscard]] base::Error start(base::ByteSource* file, const Memory& memory, std::uint32_t most_side);
    [[nodiscard]] bool has_scene() const { return has_scene_; }
    /// Empty room for the next scene, as large as that of the one that is shown: half of the arena given to start().
    [[nodiscard]] base::Arena& spare();
    /// Of a larger revision than what is shown.
    [[nodiscard]] bool is_newer(const scene::Scene& scene) const {
        return !has_scene_ || scene.header().revision > scene_.header().revision;
    }
    /// Shows a scene that was loaded into spare(), from the next plan() on. False, and nothing changes, unless its revision is
    /// larger.
    [[nodiscard]] bool take(const scene::Scene& scene);
    [[nodiscard]] const scene::Scene& scene() const { return scene_; }

    /// What colours the ground from here on, or why nothing does.
    [[nodiscard]] SpatialDataPlan plan(const design::DataStyle& design, const flight::FlightTime& time);
    /// Another number after the texels of the ground, or whether there are any, have changed; 0 before the first.
    [[nodiscard]] std::uint64_t ground_key() const { return ground_key_; }
    /// What colours the ground; null for nothing.
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

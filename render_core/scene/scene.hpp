/// A scene database in memory: layers of spatial data with their attributes and uncertainties.
///
/// Memory    all of it from the arena given to load(); nothing is read or allocated later.
/// Failure   load() verifies every checksum, size, count and range; what it accepts nobody needs to doubt again. On failure the
///           arena may be partly used: reset it.
/// Thread    const after load().
#pragma once

#include <string_view>

#include "render_core/base/fault_text.hpp"
#include "render_core/base/memory_budget.hpp"
#include "render_core/base/ports/byte_source.hpp"
#include "render_core/base/result.hpp"
#include "render_core/scene/sdb_format.hpp"

namespace tedavis::scene {

enum class SdbError : std::uint8_t { none, unreadable, not_an_sdb, wrong_version, truncated, damaged, too_large };
/// Half a sentence: "is not a scene database".
[[nodiscard]] const char* to_string(SdbError error) noexcept;

struct SdbFailure {
    SdbError error = SdbError::none;
    std::uint64_t offset = 0;
};

/// What, where and what to do, to be put behind the file's name.
[[nodiscard]] base::FaultText describe(const SdbFailure& failure) noexcept;

/// An attribute of a layer, by feature or by point.
struct Attribute {
    const AttributeEntry* entry = nullptr;
    base::Span<const float> values;
    base::Span<const Uncertainty> uncertainties;  ///< empty: all alike
    base::Span<const ValueState> states;          ///< empty: valid where there is a value
    base::Span<const char> classes;
    base::Span<const float> members;

    [[nodiscard]] std::uint32_t member_count() const { return entry->member_count; }
    /// One course of an ensemble, 0 .. member_count() - 1: its values with the states and uncertainties of the mean, which are
    /// the ensemble's.
    [[nodiscard]] Attribute member(std::uint32_t number) const;
    [[nodiscard]] ValueState state(std::size_t n) const;
    /// Whether the data state an uncertainty for any value; where not, none may be shown, sure least of all.
    [[nodiscard]] bool states_uncertainty() const;
    /// As stated, without age. Unknown where the value is missing.
    [[nodiscard]] Uncertainty uncertainty(std::size_t n) const;
    [[nodiscard]] std::string_view class_name(std::uint32_t number) const;
};

struct Run {
    std::uint32_t first = 0, count = 0;
};

struct Layer {
    const LayerEntry* entry = nullptr;
    base::Span<const ScenePoint> points;
    base::Span<const std::uint32_t> starts;
    base::Span<const float> levels_m;
    base::Span<const std::int64_t> times_ns;
    base::Span<const char> names;
    base::Span<const ModelVertex> vertices;
    base::Span<const std::uint16_t> triangles;
    base::Span<const Attribute> attributes;

    [[nodiscard]] Run points_of(std::uint32_t feature) const;
    [[nodiscard]] std::string_view name_of(std::uint32_t feature) const;  ///< empty where it has none
    [[nodiscard]] const Attribute* find(std::string_view attribute) const;
    /// Of any attribute.
    [[nodiscard]] bool states_uncertainty() const;
};

class Scene {
public:
    [[nodiscard]] static base::Result<Scene, SdbFailure> load(base::ByteSource& source, base::Arena& arena);

    [[nodiscard]] const SceneHeader& header() const { return header_; }
    [[nodiscard]] base::Span<const Layer> layers() const { return layers_; }
    [[nodiscard]] const Layer* find(std::string_view layer) const;

private:
    SceneHeader header_{};
    base::Span<const Layer> layers_;
};

}  // namespace tedavis::scene

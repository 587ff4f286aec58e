/// Reads a scene database into an arena and verifies all of it (Scene::load).
///
/// A part is accepted if it lies within the file, its size matches the layer's counts, its checksum is right, and its values are
/// in range.
#pragma once

#include "render_core/scene/scene.hpp"

namespace tedavis::scene {

class SceneReader {
public:
    SceneReader(base::ByteSource& source, base::Arena& arena) : source_(source), arena_(arena) {}

    /// Reads the header and all layers. Returns the error `none` if both are complete.
    [[nodiscard]] SdbFailure read(SceneHeader& header, base::Span<const Layer>& layers);
    /// Reads the header alone, and verifies it and the size of the file.
    [[nodiscard]] SdbFailure read_header(SceneHeader& header);

private:
    [[nodiscard]] SdbFailure read_tables(const SceneHeader& header);
    [[nodiscard]] SdbFailure read_layer(const LayerEntry& entry, Layer& layer);
    [[nodiscard]] SdbFailure read_attributes(const LayerEntry& entry, Layer& layer);
    [[nodiscard]] SdbFailure read_attribute(const AttributeEntry& entry, Attribute& attribute);
    /// Reads an array of `count` values; verifies its place, size and checksum. An empty part is damage if `count` is not 0,
    /// unless `may_be_left_out`.
    template <class T>
    [[nodiscard]] SdbFailure read_part(const ScenePart& part, std::uint64_t count, bool may_be_left_out,
                                       base::Span<const T>& values);
    [[nodiscard]] static SdbFailure damaged(std::uint64_t offset) { return {SdbError::damaged, offset}; }

    base::ByteSource& source_;
    base::Arena& arena_;
    std::uint64_t file_bytes_ = 0;
    base::Span<LayerEntry> layer_entries_;
    base::Span<AttributeEntry> attribute_entries_;
};

}  // namespace tedavis::scene

/// Heights and their bounds as the kernel reads them: raw pointers and 32-bit numbers. Borrowed.
#pragma once

#include "render_core/raytrace/height_mipmap.hpp"

namespace tedavis::raytrace {

template <class Height>
struct TracedNodes {
    const Height* posts = nullptr;
    const Height* nodes = nullptr;  ///< of all levels
    const MipmapLayout* layout = nullptr;
    std::int32_t stride = 0;             ///< of posts
    std::int32_t columns = 0, rows = 0;  ///< of cells

    explicit TracedNodes(const HeightMipmap<Height>& mipmap)
        : posts(mipmap.grid().posts),
          nodes(mipmap.level(0).nodes),
          layout(&mipmap.layout()),
          stride(static_cast<std::int32_t>(mipmap.grid().stride)),
          columns(mipmap.layout().columns[0]),
          rows(mipmap.layout().rows[0]) {}
    /// Bounds only, for rays that end before any cell.
    TracedNodes(const MipmapLayout& of, const Height* bounds)
        : nodes(bounds), layout(&of), columns(of.columns[0]), rows(of.rows[0]) {}
};

}  // namespace tedavis::raytrace

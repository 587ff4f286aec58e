/// All posts of a lattice on disk, row by row: heights and classes.
///
/// In a lattice round the Earth a window may extend over the seam: column -1 is the last but one, which is the meridian before
/// column 0. Any thread; posts must not be read while they are written.
#pragma once

#include <cstdint>
#include <string>

#include "host_sim/terrain_builder/ground.hpp"
#include "host_sim/terrain_builder/work_file.hpp"
#include "render_core/base/span.hpp"

namespace tedavis::host_sim {

class PostsFile final : public PostWindows {
public:
    /// Opens or makes `<path>.heights` and `<path>.classes`. Throws UserError.
    PostsFile(const std::string& path, std::uint32_t columns, std::uint32_t rows, bool closed);

    [[nodiscard]] std::uint32_t columns() const { return columns_; }
    [[nodiscard]] std::uint32_t rows() const { return rows_; }

    void write(std::uint32_t i, std::uint32_t j, std::uint32_t columns, std::uint32_t rows, base::Span<const float> heights_m,
               base::Span<const terrain::PostClass> classes);
    void read(LatticeWindow& window) const override;
    void sync();

private:
    void read_row(LatticeWindow& window, std::int64_t j) const;
    void read_piece(LatticeWindow& window, std::int64_t i, std::int64_t j, std::int64_t from, std::int64_t count) const;

    std::uint32_t columns_, rows_;
    bool closed_;
    WorkFile heights_, classes_;
};

}  // namespace tedavis::host_sim

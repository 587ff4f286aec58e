#include "host_sim/terrain_builder/posts_file.hpp"

#include <algorithm>

namespace tedavis::host_sim {

using terrain::PostClass;

PostsFile::PostsFile(const std::string& path, std::uint32_t columns, std::uint32_t rows, bool closed)
    : columns_(columns), rows_(rows), closed_(closed), heights_(path + ".heights"), classes_(path + ".classes") {
    const std::uint64_t posts = std::uint64_t{columns} * rows;
    heights_.resize(posts * sizeof(float));
    classes_.resize(posts);
}

void PostsFile::write(std::uint32_t i, std::uint32_t j, std::uint32_t columns, std::uint32_t rows,
                      base::Span<const float> heights_m, base::Span<const PostClass> classes) {
    for (std::uint32_t row = 0; row < rows; ++row) {
        const std::uint64_t post = std::uint64_t{j + row} * columns_ + i;
        const std::size_t from = std::size_t{row} * columns;
        heights_.write(post * sizeof(float), heights_m.data() + from, columns * sizeof(float));
        classes_.write(post, classes.data() + from, columns);
    }
}

void PostsFile::read(LatticeWindow& window) const {
    const std::size_t posts = std::size_t{window.columns} * window.rows;
    window.height_m.resize(posts);
    window.post_class.resize(posts);
    for (std::uint32_t row = 0; row < window.rows; ++row) read_row(window, window.j0 + row);
}

void PostsFile::read_row(LatticeWindow& window, std::int64_t j) const {
    const std::int64_t end = window.i0 + window.columns, period = closed_ ? columns_ - 1 : columns_;
    for (std::int64_t i = window.i0; i < end;) {
        const bool inside = j >= 0 && j < rows_ && (closed_ || (i >= 0 && i < columns_));
        if (!inside) {
            window.height_m[window.at(i, j)] = 0;
            window.post_class[window.at(i, j)] = PostClass::outside;
            ++i;
            continue;
        }
        const std::int64_t from = i >= 0 && i < columns_ ? i : ((i % period) + period) % period;
        const std::int64_t count = std::min(end - i, columns_ - from);
        read_piece(window, i, j, from, count);
        i += count;
    }
}

void PostsFile::read_piece(LatticeWindow& window, std::int64_t i, std::int64_t j, std::int64_t from, std::int64_t count) const {
    const auto post = static_cast<std::uint64_t>(j * columns_ + from);
    heights_.read(post * sizeof(float), &window.height_m[window.at(i, j)], static_cast<std::size_t>(count) * sizeof(float));
    classes_.read(post, &window.post_class[window.at(i, j)], static_cast<std::size_t>(count));
}

void PostsFile::sync() {
    heights_.sync();
    classes_.sync();
}

}  // namespace tedavis::host_sim

/// A file that appears complete or not at all: it is written beside its place as `<path>.part` and renamed at the end. Without
/// that the part is removed, and a file that was at the place stays.
///
/// Memory  none. Failure  one sentence: a missing folder, no permission, a full medium.
#pragma once

#include <string_view>

#include "render_core/base/error.hpp"
#include "target/board_config.hpp"

namespace tedavis::target {

class NewFile {
public:
    NewFile() = default;
    ~NewFile();
    NewFile(const NewFile&) = delete;
    NewFile& operator=(const NewFile&) = delete;

    /// Opens the part, so that a place that cannot be written is known before the work begins. May be called once.
    [[nodiscard]] base::Error open(const char* path);
    /// Writes the whole text and puts the file in its place.
    [[nodiscard]] base::Error write(std::string_view text);

private:
    [[nodiscard]] base::Error write_all(std::string_view text) const;

    Path path_, part_;
    int descriptor_ = -1;
};

}  // namespace tedavis::target

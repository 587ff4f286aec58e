/// Folders as `replay` leaves them, for tests of what compares them.
#pragma once

#include "host_sim/png_file.hpp"
#include "host_sim/reports/frame_record_writer.hpp"
#include "host_sim/reports/run_folder.hpp"
#include "tests/support/files/temporary_folder.hpp"
#include "tests/support/flights/frame_result.hpp"

namespace tedavis::test_support {

/// A run of five frames; `change` may alter each result before it is written.
template <class Change>
void write_run(const TemporaryFolder& place, const std::string& name, Change change, std::uint64_t frames = 5) {
    std::filesystem::create_directories(place.file(name + "/" + host_sim::kFramesFolder));
    host_sim::FrameRecordWriter writer(place.file(name), base::Time{0});
    for (std::uint64_t n = 0; n < frames; ++n) {
        host_sim::FrameResult result = frame_result(n, 0.1 * static_cast<double>(n));
        change(result);
        writer.write(result);
    }
    writer.commit();
}

inline void write_picture(const TemporaryFolder& place, const std::string& run, std::uint64_t frame,
                          const host_sim::RgbaPicture& picture) {
    host_sim::write_png(host_sim::frame_picture_path(place.file(run), frame), host_sim::view_of(picture));
}

}  // namespace tedavis::test_support

/// Writes pictures while the next ones are drawn: a thread of its own encodes them, in the order of add().
///
/// A picture appears whole or not at all (png_file.hpp), and has the bytes that write_png gives it.
#pragma once

#include <condition_variable>
#include <deque>
#include <exception>
#include <mutex>
#include <string>
#include <thread>

#include "host_sim/png_file.hpp"

namespace tedavis::host_sim {

class PictureWriter {
public:
    PictureWriter() : thread_([this] { run(); }) {}
    /// Writes the pictures in the queue; does not report failures.
    ~PictureWriter();
    PictureWriter(const PictureWriter&) = delete;
    PictureWriter& operator=(const PictureWriter&) = delete;

    /// Copies the picture into the queue; blocks while kMaxWaiting pictures are in it. Throws UserError where an earlier one
    /// could not be written.
    void add(const std::string& path, const RgbaView& view);
    /// Returns when every picture is written. Throws UserError where one could not be.
    void finish();

    static constexpr std::size_t kMaxWaiting = 4;

private:
    struct Waiting {
        std::string path;
        RgbaPicture picture;
    };

    void run();
    void write_first(std::unique_lock<std::mutex>& lock);
    void throw_failure();

    std::mutex mutex_;
    std::condition_variable changed_;
    std::deque<Waiting> waiting_;  ///< the first one is being written
    std::exception_ptr failure_;   ///< error of the first picture that could not be written; later ones are not written
    bool ends_ = false;
    std::thread thread_;  ///< last: it uses all others
};

}  // namespace tedavis::host_sim

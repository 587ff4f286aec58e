#include "host_sim/console.hpp"

#include "host_sim/time_left.hpp"

namespace tedavis::host_sim {

void Console::result(std::string_view text, std::string_view json) {
    progress_done();
    if (results_ != nullptr) write_line(*results_, json_ ? json : text);
}

Console Console::without_result() const {
    Console same = *this;
    same.results_ = nullptr;
    return same;
}

void Console::note(std::string_view message) {
    progress_done();
    write_line(*notes_, message);
}

void Console::progress(std::string_view what, std::uint64_t done, std::uint64_t total) {
    if (!live_ || total == 0) return;
    const auto now = std::chrono::steady_clock::now();
    if (shown_percent_ < 0 || what != shown_what_) {
        shown_what_ = what;
        shown_percent_ = -1;
        begun_ = now;
    }
    const double share = static_cast<double>(done) / static_cast<double>(total);
    const int percent = static_cast<int>(static_cast<double>(done) * 100.0 / static_cast<double>(total));
    if (percent == shown_percent_ && now - drawn_ < std::chrono::seconds(1)) return;
    shown_percent_ = percent;
    drawn_ = now;
    const std::string left = time_left(std::chrono::duration<double>(now - begun_).count(), share);
    std::string line = shown_what_ + ' ' + std::to_string(percent) + " %" + (left.empty() ? "" : ", " + left);
    const std::size_t length = line.size();
    if (length < shown_length_) line.append(shown_length_ - length, ' ');  // covers what stood there
    shown_length_ = length;
    *notes_ << '\r' << line << std::flush;
}

void Console::progress_done() {
    if (shown_percent_ < 0) return;
    shown_percent_ = -1;
    shown_length_ = 0;
    *notes_ << '\n' << std::flush;
}

void Console::write_line(std::ostream& stream, std::string_view text) {
    stream << text;
    if (text.empty() || text.back() != '\n') stream << '\n';
    stream << std::flush;
}

}  // namespace tedavis::host_sim

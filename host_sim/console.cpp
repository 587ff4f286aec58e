#include "host_sim/console.hpp"

#include <string>

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
    if (total == 0) return;
    const auto now = std::chrono::steady_clock::now();
    if (shown_percent_ < 0 || what != shown_what_) {
        shown_what_ = what;
        shown_percent_ = -1;
        begun_ = now;
        if (!live_) drawn_ = now;
    }
    const double share = static_cast<double>(done) / static_cast<double>(total);
    const int percent = static_cast<int>(static_cast<double>(done) * 100.0 / static_cast<double>(total));
    const bool is_new = live_ && percent != shown_percent_;
    shown_percent_ = percent;
    if (!is_new && now - drawn_ < (live_ ? std::chrono::milliseconds(1000) : between_lines_)) return;
    drawn_ = now;
    const std::string left = time_left(std::chrono::duration<double>(now - begun_).count(), share);
    const std::string line = shown_what_ + ' ' + std::to_string(percent) + " %" + (left.empty() ? "" : ", " + left);
    if (live_)
        redraw(line);
    else
        write_line(*notes_, line);
}

void Console::redraw(const std::string& line) {
    const std::size_t covered = line.size() < shown_length_ ? shown_length_ - line.size() : 0;
    shown_length_ = line.size();
    *notes_ << '\r' << line << std::string(covered, ' ') << std::flush;
}

void Console::progress_done() {
    if (shown_percent_ < 0) return;
    shown_percent_ = -1;
    shown_length_ = 0;
    if (live_) *notes_ << '\n' << std::flush;
}

std::optional<bool> Console::confirm(std::string_view question) {
    if (answers_ == nullptr) return std::nullopt;
    progress_done();
    *notes_ << question << " [y/N] " << std::flush;
    std::string answer;
    std::getline(*answers_, answer);
    if (answers_->eof()) *notes_ << '\n' << std::flush;  // nobody has ended the line
    return !answer.empty() && (answer[0] == 'y' || answer[0] == 'Y');
}

void Console::write_line(std::ostream& stream, std::string_view text) {
    stream << text;
    if (text.empty() || text.back() != '\n') stream << '\n';
    stream << std::flush;
}

}  // namespace tedavis::host_sim

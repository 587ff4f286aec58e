#include "bus/candump/line_reader.hpp"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "tests/bus/text_bytes.hpp"

namespace tedavis::bus::test_line_reader {
namespace {

std::vector<std::string> read_all(LineReader& reader) {
    std::vector<std::string> lines;
    std::string_view line;
    while (true) {
        const LineReader::Status status = reader.next(line);
        if (status == LineReader::Status::end || status == LineReader::Status::failed) return lines;
        lines.emplace_back(status == LineReader::Status::too_long ? "<too long>" : std::string(line));
    }
}

std::string long_text() {
    std::string text;
    for (int i = 0; i < 3000; ++i)
        text += "line " + std::to_string(i) + std::string(static_cast<std::size_t>(i % 97), 'x') + "\n";
    text += "\n" + std::string(9 * kMaxLogLine, 'y') + "\n" + std::string(kMaxLogLine, 'z') + "\n" +
            std::string(kMaxLogLine + 1, 'w') + "\nlast without newline";
    return text;
}

TEST(LineReader, MemoryAndWindowGiveTheSameLines) {
    const std::string text = long_text();
    LineReader whole(base::Span<const char>(text.data(), text.size()));
    TextBytes bytes(text);
    std::vector<char> window(kMinLogWindow);
    LineReader streamed(bytes, {window.data(), window.size()});
    const std::vector<std::string> lines = read_all(whole);
    EXPECT_EQ(lines, read_all(streamed));
    ASSERT_EQ(lines.size(), 3005u);
    EXPECT_EQ(lines[3000], "");
    EXPECT_EQ(lines[3001], "<too long>");
    EXPECT_EQ(lines[3002], std::string(kMaxLogLine, 'z'));
    EXPECT_EQ(lines[3003], "<too long>");
    EXPECT_EQ(lines[3004], "last without newline");
}

TEST(LineReader, SeeksToAnyLineInBothModes) {
    const std::string text = long_text();
    LineReader whole(base::Span<const char>(text.data(), text.size()));
    TextBytes bytes(text);
    std::vector<char> window(kMinLogWindow);
    LineReader streamed(bytes, {window.data(), window.size()});
    std::string_view line;
    for (LineReader* reader : {&whole, &streamed}) {
        std::vector<std::pair<std::uint64_t, std::string>> places;
        for (int i = 0; i < 2900; ++i) {
            const std::uint64_t offset = reader->offset();
            ASSERT_EQ(reader->next(line), LineReader::Status::line);
            places.emplace_back(offset, line);
        }
        for (const std::size_t index :
             {std::size_t{2899}, std::size_t{0}, std::size_t{1500}, std::size_t{1499}, std::size_t{2000}}) {
            reader->seek(places[index].first);
            ASSERT_EQ(reader->next(line), LineReader::Status::line);
            EXPECT_EQ(line, places[index].second);
        }
        reader->seek(text.size() + 100);
        EXPECT_EQ(reader->next(line), LineReader::Status::end);
    }
}

TEST(LineReader, EmptyText) {
    LineReader reader(base::Span<const char>{});
    std::string_view line;
    EXPECT_EQ(reader.next(line), LineReader::Status::end);
    EXPECT_EQ(reader.next(line), LineReader::Status::end);
}

TEST(LineReader, AFailingMediumIsSaid) {
    const std::string text = long_text();
    TextBytes bytes(text);
    bytes.fail_beyond(20000);
    std::vector<char> window(kMinLogWindow);
    LineReader reader(bytes, {window.data(), window.size()});
    std::string_view line;
    LineReader::Status status = LineReader::Status::line;
    for (int i = 0; i < 5000 && status == LineReader::Status::line; ++i) status = reader.next(line);
    EXPECT_EQ(status, LineReader::Status::failed);
}

}  // namespace
}  // namespace tedavis::bus::test_line_reader

#include "platform/egl_kms/card_holder.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <string>

#include "tests/support/files/temporary_folder.hpp"

namespace tedavis::platform::test_card_holder {
namespace {

using ::testing::HasSubstr;
namespace fs = std::filesystem;

/// A folder that stands for /proc, and a plain file that stands for a card.
struct CardHolder : testing::Test {
    void SetUp() override {
        card = folder.write("card0", "card");
        other = folder.write("card1", "card");
        processes = folder.file("proc");
        fs::create_directories(processes + "/sys");
    }
    void process(const std::string& number, const std::string& name, const std::string& opened) {
        fs::create_directories(processes + "/" + number + "/fd");
        std::ofstream(processes + "/" + number + "/comm") << name << '\n';
        fs::create_symlink(other, processes + "/" + number + "/fd/0");
        fs::create_symlink(opened, processes + "/" + number + "/fd/5");
        fs::create_symlink("socket:[1]", processes + "/" + number + "/fd/6");
    }
    std::string holders() const { return find_card_holders(card.c_str(), processes.c_str()).c_str(); }
    test_support::TemporaryFolder folder;
    std::string card, other, processes;
};

TEST_F(CardHolder, NamesTheProgramThatHasTheCardOpen) {
    process("812", "Xorg", card);
    process("900", "weston", other);
    EXPECT_EQ(holders(), "Xorg (process 812)");
}

TEST_F(CardHolder, ALinkToTheCardIsTheCard) {
    fs::create_symlink(card, folder.file("by-path"));
    process("812", "Xorg", card);
    EXPECT_EQ(find_card_holders(folder.file("by-path").c_str(), processes.c_str()).view(), "Xorg (process 812)");
}

TEST_F(CardHolder, NeitherThisProgramNorASeatManagerHasIt) {
    process(std::to_string(getpid()), "tedavis-display", card);
    process("400", "systemd-logind", card);
    process("401", "seatd", card);
    EXPECT_EQ(holders(), "");
}

TEST_F(CardHolder, WhatCannotBeFoundOutIsEmpty) {
    EXPECT_EQ(holders(), "");
    EXPECT_EQ(find_card_holders(folder.file("absent").c_str(), processes.c_str()).view(), "");
    EXPECT_EQ(find_card_holders(card.c_str(), folder.file("absent").c_str()).view(), "");
    process("7", "", card);
    EXPECT_EQ(holders(), "a program (process 7)");
}

TEST_F(CardHolder, TheSentenceNamesWhoOrWhatItMayBe) {
    EXPECT_THAT(std::string(held_card_error("/dev/dri/card0 (vc4)", "Xorg (process 812)").message.view()),
                HasSubstr("/dev/dri/card0 (vc4): another program has the screen: Xorg (process 812); end it first"));
    EXPECT_THAT(std::string(held_card_error("card", "").message.view()), HasSubstr("a desktop, or another tedavis-display"));
}

TEST_F(CardHolder, WhatIsNotThereIsNotHeld) { EXPECT_FALSE(is_card_held(folder.file("absent").c_str())); }

}  // namespace
}  // namespace tedavis::platform::test_card_holder

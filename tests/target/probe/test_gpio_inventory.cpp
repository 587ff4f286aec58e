// What a chip lists is shown on an emulated one (tests/board); here is what is no chip, and what may not be opened.
#include "target/probe/gpio_inventory.hpp"

#include <gtest/gtest.h>

#include <memory>

#include "tests/support/files/temporary_folder.hpp"

namespace tedavis::target::test_gpio_inventory {
namespace {

TEST(GpioInventory, APlainFileIsNoChip) {
    test_support::TemporaryFolder folder;
    folder.write("gpiochip0", "no chip");
    folder.write("gpiochipx", "no chip");
    const auto inventory = std::make_unique<GpioInventory>();
    list_gpio(*inventory, folder.file("").c_str());
    EXPECT_TRUE(inventory->chips.empty());
}

TEST(GpioInventory, WithoutTheFolderThereIsNoChip) {
    const auto inventory = std::make_unique<GpioInventory>();
    ASSERT_TRUE(inventory->chips.try_push_back(GpioChip()));
    list_gpio(*inventory, "/nowhere/at/all");
    EXPECT_TRUE(inventory->chips.empty()) << "the list is made anew";
}

}  // namespace
}  // namespace tedavis::target::test_gpio_inventory

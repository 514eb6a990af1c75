// The letters of the HUD: 5 pixels wide, 7 high and 2 below the line.
#pragma once

#include <array>
#include <cstdint>

namespace anteroom::vulkan {

inline constexpr int kGlyphWidth = 5, kGlyphHeight = 9;

namespace font {

struct Glyphs {
  const char* characters;
  std::array<const char*, kGlyphHeight> rows;  // a column apart
};

inline constexpr Glyphs kAll[] = {
    // clang-format off
    {"0123456789",
     {" ###    #    ###   ###     #  #####   ##  #####  ###   ### ",
      "#   #  ##   #   # #   #   ##  #      #        # #   # #   #",
      "#  ## # #       #     #  # #  ####  #        #  #   # #   #",
      "# # #   #     ##    ##  #  #      # ####     #   ###   ####",
      "##  #   #    #        # #####     # #   #   #   #   #     #",
      "#   #   #   #     #   #    #  #   # #   #   #   #   #    # ",
      " ###  ##### #####  ###     #   ###   ###    #    ###   ##  ",
      "                                                           ",
      "                                                           "}},
    {"abcdefghijklm",
     {"      #               #         ##        #       #      #  #      ##        ",
      "      #               #        #          #                 #       #        ",
      " ###  ####   ####  ####  ###  ####   #### ####   ##     ##  #  #    #   ## # ",
      "    # #   # #     #   # #   #  #    #   # #   #   #      #  # #     #   # # #",
      " #### #   # #     #   # #####  #    #   # #   #   #      #  ##      #   # # #",
      "#   # #   # #     #   # #      #    #   # #   #   #      #  # #     #   # # #",
      " #### ####   ####  ####  ####  #     #### #   #  ###     #  #  #   ###  # # #",
      "                                        #             #  #                   ",
      "                                     ###               ##                    "}},
    {"nopqrstuvwxyz",
     {"                                     #                                       ",
      "                                     #                                       ",
      "####   ###  ####   #### # ##   #### ####  #   # #   # #   # #   # #   # #####",
      "#   # #   # #   # #   # ##    #      #    #   # #   # # # #  # #  #   #    # ",
      "#   # #   # #   # #   # #      ###   #    #   #  # #  # # #   #   #   #   #  ",
      "#   # #   # #   # #   # #         #  #    #   #  # #  # # #  # #  #   #  #   ",
      "#   #  ###  ####   #### #     ####    ##   ####   #    # #  #   #  #### #####",
      "            #         #                                               #      ",
      "            #         #                                            ###       "}},
    {"ABCDEFGHIJKLM",
     {" ###  ####   ###  ####  ##### #####  ###  #   #  ###    ### #   # #     #   #",
      "#   # #   # #   # #   # #     #     #   # #   #   #      #  #  #  #     ## ##",
      "#   # #   # #     #   # #     #     #     #   #   #      #  # #   #     # # #",
      "##### ####  #     #   # ####  ####  # ### #####   #      #  ##    #     # # #",
      "#   # #   # #     #   # #     #     #   # #   #   #      #  # #   #     #   #",
      "#   # #   # #   # #   # #     #     #   # #   #   #   #  #  #  #  #     #   #",
      "#   # ####   ###  ####  ##### #      ###  #   #  ###   ##   #   # ##### #   #",
      "                                                                             ",
      "                                                                             "}},
    {"NOPQRSTUVWXYZ",
     {"#   #  ###  ####   ###  ####   #### ##### #   # #   # #   # #   # #   # #####",
      "##  # #   # #   # #   # #   # #       #   #   # #   # #   # #   # #   #     #",
      "##  # #   # #   # #   # #   # #       #   #   # #   # #   #  # #   # #     # ",
      "# # # #   # ####  #   # ####   ###    #   #   # #   # # # #   #     #     #  ",
      "#  ## #   # #     # # # # #       #   #   #   #  # #  # # #  # #    #    #   ",
      "#  ## #   # #     #  #  #  #      #   #   #   #  # #  ## ## #   #   #   #    ",
      "#   #  ###  #      ## # #   # ####    #    ###    #   #   # #   #   #   #####",
      "                                                                             ",
      "                                                                             "}},
    {".,:/%+-=()",
     {"                      # ##  #                      #   #   ",
      "                      # ##  #                     #     #  ",
      "             ##      #     #    #                #       # ",
      "             ##     #     #     #         #####  #       # ",
      "                   #     #    #####  ###         #       # ",
      " ##    ##    ##   #     #  ##   #         #####   #     #  ",
      " ##     #    ##   #     #  ##   #                  #   #   ",
      "       #                                                   ",
      "                                                           "}},
    // clang-format on
};

}  // namespace font

// The glyphs of the 96 characters from the space on: two words each, bit (row * kGlyphWidth + column), that
// of the upper left first. Those that have none show nothing.
constexpr std::array<uint32_t, 192> packedFont() {
  std::array<uint32_t, 192> packed{};
  for (const font::Glyphs& glyphs : font::kAll)
    for (int i = 0; glyphs.characters[i]; ++i)
      for (int bit = 0; bit < kGlyphWidth * kGlyphHeight; ++bit) {
        const int row = bit / kGlyphWidth, column = i * (kGlyphWidth + 1) + bit % kGlyphWidth;
        if (glyphs.rows[static_cast<size_t>(row)][column] == ' ') continue;
        packed[static_cast<size_t>(2 * (glyphs.characters[i] - ' ') + bit / 32)] |= 1u << bit % 32;
      }
  return packed;
}

}  // namespace anteroom::vulkan

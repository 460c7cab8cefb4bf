#pragma once
// Colours for the display
#include <string>
namespace ui {
  constexpr int X10 = 10;
  enum class Colour { Red, Green, Blue };
  std::string name(Colour c);
}

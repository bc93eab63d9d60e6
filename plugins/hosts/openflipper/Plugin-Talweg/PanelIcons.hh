// Small icons in the colour of the panel's text.
#pragma once

#include <QIcon>

namespace talweg::openflipper {

enum class Sign {
  kPencil,
  kTick,
  kLoop,
  kBack,
  kForward,
  kCross,
  kBin,
  kFrom,
  kRead,
  kWrite,
  kScissors,
  kParts,
  kInside,
  kTool,
  kPin,
  kOffset,
};

QIcon icon_of(Sign sign);

}  // namespace talweg::openflipper

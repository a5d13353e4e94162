#pragma once
#include "openevc/evc.h"
#include "openevc/openevc.h"

namespace evc::capi {

/// How many a list of the kernel has room for.
template <class List>
inline constexpr std::size_t kRoom = List::capacity();

/// All members of `to` but its size.
void give_outputs(openevc_outputs& to, const kernel::Outputs& outputs) noexcept;

/// The same of the advance display; null: there is none.
void give_planning(openevc_planning& to, const kernel::Planning* planning) noexcept;

/// The same of the record of the display, whose planning is in `display.planning`.
void give_display(openevc_display& to, const kernel::Display& display) noexcept;
/// Members of a block of stored data; covers are beside it.
void give_stored(openevc_data& to, const kernel::ShownData& data) noexcept;
void give_cover(openevc_data& to, const kernel::ShownCover& cover) noexcept;

}  // namespace evc::capi

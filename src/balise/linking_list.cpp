#include "balise/linking.h"
#include "lang/si.h"

namespace evc::balise {
namespace {

LinkingList::Entry entry_of(lang::var::Q_SCALE Q_SCALE, const lang::Packet5_links& link) {
  LinkingList::Entry entry;
  entry.D_LINK = lang::metres(Q_SCALE, link.D_LINK);
  if (link.Q_NEWCOUNTRY.raw == 1) entry.NID_C = link.NID_C.raw;
  entry.NID_BG = link.NID_BG.raw;
  entry.nominal = link.Q_LINKORIENTATION.raw == 1;
  entry.reaction = reaction_of(link.Q_LINKREACTION.raw).value_or(Reaction::trip);  // a spare code: the most severe one
  entry.Q_LOCACC = lang::metres(link.Q_LOCACC);
  return entry;
}

}  // namespace

LinkingList linking_list(const lang::Packet5& packet) {
  LinkingList list;
  EVC_REQUIRE(list.entries.push_back(entry_of(packet.Q_SCALE, packet.first_links())));
  for (const lang::Packet5_links& link : packet.links)
    EVC_REQUIRE(list.entries.push_back(entry_of(packet.Q_SCALE, link)));
  return list;
}

}  // namespace evc::balise

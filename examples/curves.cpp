// Braking curves and supervision limits with openevc::curves alone: one header, no files; only this program uses the
// heap. The same case as data/curves/passenger_eoa.json.
#include <openevc/curves.h>

#include <cstdio>
#include <memory>

using namespace evc::literals;
namespace sdm = evc::sdm;
namespace train = evc::train;

int main() {
  sdm::Inputs in;
  in.revision = 1;  // changed whenever another member changes
  in.srs = evc::SrsVersion::v3_6_0;
  in.train.brake_percentage = 150.0;  // the rest is the standard train: lambda, position P
  in.train.L_TRAIN = 400_m;
  in.train.V_MAXTRAIN = 200_km_h;
  if (const train::Fault fault = train::check(in.train); fault != train::Fault::none) {
    std::printf("train data refused: fault %d of openevc/train/brake_model.h\n", static_cast<int>(fault));
    return 2;
  }
  bool room = in.gradient.permille.append({0_m}, 0.0) && in.gradient.permille.append({4000_m}, -5.0);
  room = room && in.mrsp.append({0_m}, 160_km_h);
  in.authority.kind = sdm::Authority::Kind::EOA_SvL;
  in.authority.EOA = in.authority.SvL = {7000_m};
  in.authority.release_speed = evc::ReleaseSpeedChoice::value;
  in.authority.V_release = 30_km_h;
  if (!room) return 2;

  // Large, so not on the stack; `rebuild` itself allocates nothing.
  const auto derived = std::make_unique<sdm::Derived>();
  sdm::rebuild(*derived, in);
  const sdm::Target& target = derived->targets.back();

  std::printf("metres before the end of authority\n%6s %9s %9s %9s %9s %9s\n", "km/h", "EBD", "EBI", "SBI", "P", "I");
  for (int kmh = 20; kmh <= 160; kmh += 20) {
    const evc::Speed V{kmh / 3.6};
    const sdm::Explanation e = sdm::explain(*derived, in, target, V, 0_km_h, 0_m_s2);
    const auto before = [&](evc::Place place) { return (target.d_target - place).si; };
    std::printf("%6d %9.1f %9.1f %9.1f %9.1f %9.1f\n", kmh, before(e.d_EBD), before(*e.EBD.d_EBI), before(e.d_FLOI),
                before(e.d_P), before(e.d_I));
  }

  // One cycle of supervision: the train at 4800 m with 140 km/h.
  sdm::Supervision state;
  sdm::Motion motion;
  motion.est_front = motion.min_safe_front = motion.max_safe_front = {4800_m};
  motion.V_est = 140_km_h;
  const sdm::Result now = sdm::supervise(state, *derived, motion);
  std::printf("at 4800 m with 140 km/h: permitted %.1f km/h, %s\n", now.V_P.si * 3.6,
              now.status == evc::Status::Indication ? "Indication" : "another status");
  return now.status == evc::Status::Indication ? 0 : 1;
}

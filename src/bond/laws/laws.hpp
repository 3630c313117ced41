// The laws of this build, one function a law; law_catalogue.cpp puts them in the order of the listing.
#pragma once

#include "bondstatic/bond_law.hpp"

namespace bondstatic {

BondLaw parallel_law();
BondLaw pfc_parallel_law();
BondLaw euler_bernoulli_law();
BondLaw timoshenko_law();
BondLaw obermayr_law();
BondLaw edem_v2_law();
BondLaw contact_law();
BondLaw two_segment_law();
BondLaw concave_end_law();
BondLaw generic_law();

}  // namespace bondstatic

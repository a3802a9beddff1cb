// Counts pixels by what became of them, DepthConditioner::kTallies. What becomes of nearly all, to
// be held, is not counted here but left over there: counting in common costs more than deciding.
const uint kMissing = 0u, kRejected = 1u, kDoubtful = 2u, kFlyingRemoved = 3u, kSettling = 4u,
           kPassed = 5u, kMixed = 6u, kCorrected = 7u, kKept = 8u, kFilled = 9u, kHoles = 10u;

layout(std430, binding = 1) buffer Tallies { uint tallies[]; };

void tally(uint what) { atomicAdd(tallies[what], 1u); }

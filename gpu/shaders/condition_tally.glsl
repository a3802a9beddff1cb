// Counts pixels by what became of them, gpu::ConditionTally: within a group first, because one
// counter for the whole picture would be fought for.
const uint kTallies = 11u;
const uint kMissing = 0u, kRejected = 1u, kDoubtful = 2u, kFlyingRemoved = 3u, kSettling = 4u,
           kHeld = 5u, kPassed = 6u, kKept = 7u, kCorrected = 8u, kFilled = 9u, kHoles = 10u;

layout(std430, binding = 1) buffer Tallies { uint tallies[]; };
shared uint groupTallies[kTallies];

void startTallies() {
    if (gl_LocalInvocationIndex < kTallies) groupTallies[gl_LocalInvocationIndex] = 0u;
    barrier();
}

void tally(uint what) { atomicAdd(groupTallies[what], 1u); }

void finishTallies() {
    barrier();
    uint index = gl_LocalInvocationIndex;
    if (index < kTallies && groupTallies[index] > 0u) atomicAdd(tallies[index], groupTallies[index]);
}

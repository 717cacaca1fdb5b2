// The report of a kernel about one ray and one object, with the answer of every step of the exact intersection. All
// fields are numbers, so that each row of the output is a row of reals.

struct ExactReport {
    // The number of the first certain step: 1 for the plain formula with its bound, 2 for the compensated formula. It
    // is 0 if no step is certain. Then dyadic arithmetic would decide, which only the CPU has.
    step: real,
    // The answer of that step: 1 for a hit, its lambda and its part.
    some: real,
    lambda: real,
    part: real,
    // The answer of each step for itself: 0 if it is uncertain, 1 for a miss, and 2, 3 or 4 for a hit with the side,
    // the top or the bottom. A lambda is 0 without a hit.
    plain: real,
    plain_lambda: real,
    compensated: real,
    compensated_lambda: real,
}

// Returns the number for an answer.
fn exact_code(decision: Decision) -> real {
    if !decision.certain {
        return real(0.0);
    }
    return select(real(1.0), real(2u + decision.part), decision.some);
}

// Returns the report of the two steps' answers.
fn exact_report(plain: Decision, compensated: Decision) -> ExactReport {
    var answer = plain;
    var step = real(1.0);
    if !plain.certain {
        answer = compensated;
        step = select(real(0.0), real(2.0), compensated.certain);
    }
    return ExactReport(
        step,
        select(real(0.0), real(1.0), answer.some),
        answer.lambda,
        real(answer.part),
        exact_code(plain),
        plain.lambda,
        exact_code(compensated),
        compensated.lambda,
    );
}

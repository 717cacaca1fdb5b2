// The report of a kernel about one ray and one object, with the answer of every step of the exact intersection. All
// fields are numbers, so that each row of the output is a row of reals.

struct ExactReport {
    // The number of the first certain step: 1 for the plain formula with its bound, 2 for the compensated formula, 3
    // for double-double. It is 0 if no step is certain. Then dyadic arithmetic would decide, which only the CPU has.
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
    doubled: real,
    doubled_high: real,
    doubled_low: real,
}

// Returns the number for an answer.
fn exact_code(certain: bool, some: bool, part: u32) -> real {
    if !certain {
        return real(0.0);
    }
    return select(real(1.0), real(2u + part), some);
}

// Returns the report of the three steps' answers.
fn exact_report(plain: Decision, compensated: Decision, doubled: PreciseDecision) -> ExactReport {
    var report: ExactReport;
    report.plain = exact_code(plain.certain, plain.some, plain.part);
    report.plain_lambda = plain.lambda;
    report.compensated = exact_code(compensated.certain, compensated.some, compensated.part);
    report.compensated_lambda = compensated.lambda;
    report.doubled = exact_code(doubled.certain, doubled.some, doubled.part);
    report.doubled_high = doubled.lambda.high;
    report.doubled_low = doubled.lambda.low;
    var answer = plain;
    report.step = real(1.0);
    if !plain.certain {
        answer = compensated;
        report.step = real(2.0);
        if !compensated.certain {
            answer = Decision(doubled.certain, doubled.some, doubled.lambda.high, doubled.part);
            report.step = select(real(0.0), real(3.0), doubled.certain);
        }
    }
    report.some = select(real(0.0), real(1.0), answer.some);
    report.lambda = answer.lambda;
    report.part = real(answer.part);
    return report;
}

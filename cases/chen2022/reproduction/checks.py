"""Every comparison of a found number with its closed form, and what became of it."""

# Found and closed form are both rounded to double a few dozen times; what is found in practice is below 1e-15.
TOLERANCE = 1e-13


class Checks:
    def __init__(self):
        self.failures = []
        self.counts = {}
        self.worst = {}

    def equal(self, subject, what, found, expected, size=None, tolerance=TOLERANCE):
        """|found - expected| <= tolerance * size. `size` is |expected|, unless the number is a difference of larger
        ones. Returns `found`."""
        error = abs(found - expected) / (abs(expected) if size is None else size)
        self.counts[subject] = self.counts.get(subject, 0) + 1
        self.worst[subject] = max(self.worst.get(subject, 0), error)
        if not error <= tolerance:  # nor where it is NaN
            self.failures.append(f"{subject}: {what}: found {found!r}, closed form {expected!r}, off by {error:.1e}, "
                                 f"allowed {tolerance:.0e}")
        return found

    def printed(self, subject, what, found, printed, last_digits=1.0):
        """`found` against a number in print, within so many units of its last digit: 0.5 where it is rounded, 1 where
        digits may have been cut off."""
        decimals = len(printed.partition(".")[2])
        self.counts[subject] = self.counts.get(subject, 0) + 1
        # A rounding of the product itself must not decide a tie.
        if not abs(found - float(printed)) <= (last_digits + 1e-9) * 10**-decimals:
            self.failures.append(f"{subject}: {what}: found {found!r}, printed {printed}")

    def report(self):
        lines = [f"  {subject:10} {count:4} numbers, " +
                 (f"off by {self.worst[subject]:.1e} at most" if subject in self.worst else "as printed")
                 for subject, count in self.counts.items()]
        return "\n".join(lines)

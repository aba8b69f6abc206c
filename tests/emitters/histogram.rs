//! Pearson's chi-square test of counts against expectations.

/// How far the counts are from what is expected, in standard deviations of a normal distribution (Wilson and Hilferty,
/// The Distribution of Chi-Square, 1931). Bins that expect fewer than five are put together.
pub fn deviation(counts: &[u64], expected: &[f64]) -> f64 {
    assert_eq!(counts.len(), expected.len());
    let (mut statistic, mut bins) = (0.0, 0);
    let (mut rest_count, mut rest_expected) = (0.0, 0.0);
    for (&count, &expected) in counts.iter().zip(expected) {
        if expected == 0.0 {
            assert_eq!(count, 0, "drawn where the density is 0");
        } else if expected < 5.0 {
            rest_count += count as f64;
            rest_expected += expected;
        } else {
            statistic += (count as f64 - expected).powi(2) / expected;
            bins += 1;
        }
    }
    if rest_expected >= 5.0 {
        statistic += (rest_count - rest_expected).powi(2) / rest_expected;
        bins += 1;
    }
    assert!(bins > 1, "too few bins");
    let freedom = f64::from(bins - 1);
    let spread = 2.0 / (9.0 * freedom);
    ((statistic / freedom).cbrt() - (1.0 - spread)) / spread.sqrt()
}

#[test]
fn finds_a_wrong_density() {
    let expected = [1000.0; 20];
    let fair: Vec<u64> = (0..20).map(|bin| 1000 + (bin * 37 % 61) - 30).collect();
    let mut unfair = fair.clone();
    unfair[3] += 250;
    unfair[4] -= 250;
    assert!(deviation(&fair, &expected) < 4.0);
    assert!(deviation(&unfair, &expected) > 4.0);
}

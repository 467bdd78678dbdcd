//! Progress on a terminal.

use std::time::Duration;

use indicatif::{HumanDuration, ProgressBar, ProgressState, ProgressStyle};

/// A bar of `total` steps with an estimate of the time left; hidden where standard error is no terminal.
pub(super) fn bar(what: &'static str, total: u64) -> ProgressBar {
    let style = ProgressStyle::with_template("{msg} [{bar:40}] {human_pos}/{human_len} {left}");
    let bar = ProgressBar::new(total).with_message(what);
    if let Ok(style) = style {
        // Nothing is known of the time before the first step is done.
        let left = |state: &ProgressState, to: &mut dyn std::fmt::Write| {
            let _ = if state.pos() == 0 { Ok(()) } else { write!(to, "{:#} left", HumanDuration(state.eta())) };
        };
        bar.set_style(style.with_key("left", left).progress_chars("=> "));
    }
    // Drawn at once and each second: a step may take a minute.
    bar.enable_steady_tick(Duration::from_secs(1));
    bar.tick();
    bar
}

/// Shows how much is done, where the whole is not known before.
pub(super) fn show(bar: &ProgressBar, done: usize, of: usize) {
    bar.set_length(of as u64);
    bar.set_position(done as u64);
}

/// Shows what is done, how much of it and of how much.
pub(super) fn steps(bar: &ProgressBar) -> impl Fn(&'static str, usize, usize) + Sync {
    move |what, done, of| {
        bar.set_message(what);
        show(bar, done, of);
    }
}

/// A spinner for work whose length is not known.
pub(super) fn spinner(what: String) -> ProgressBar {
    let spinner = ProgressBar::new_spinner().with_message(what);
    spinner.enable_steady_tick(Duration::from_millis(120));
    spinner
}

// The mixture of rays that leave an asset, by its surface.

fn surface_lobes(surface: u32) -> Lobes {
    let is_fiber = surface_kind(surface) == OF_FIBERS;
    return Lobes(is_fiber, surface_lobe_shares(surface), surface_lobe_widths(surface));
}

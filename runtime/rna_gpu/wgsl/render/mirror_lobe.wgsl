// Directions about the mirror direction: highlights of rough and of smooth materials.

// Cosine to the mirror direction: a mixture of widths, which u chooses, too.
fn mirror_cosine(u: f32) -> f32 {
    let second = u - MIRROR_PARTS.x;
    let third = second - MIRROR_PARTS.y;
    if second < 0.0 {
        return fisher_cosine(u / MIRROR_PARTS.x, MIRROR_KAPPAS.x);
    }
    if third < 0.0 {
        return fisher_cosine(second / MIRROR_PARTS.y, MIRROR_KAPPAS.y);
    }
    return fisher_cosine(min(third / MIRROR_PARTS.z, 1.0), MIRROR_KAPPAS.z);
}

fn mirror_pdf(cosine: f32) -> f32 {
    let pdfs = vec3f(
        fisher_pdf(cosine, MIRROR_KAPPAS.x), fisher_pdf(cosine, MIRROR_KAPPAS.y), fisher_pdf(cosine, MIRROR_KAPPAS.z),
    );
    return dot(MIRROR_PARTS, pdfs);
}

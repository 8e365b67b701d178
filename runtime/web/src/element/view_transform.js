// The view transforms of rna-run, for what has to look the same under each; the shaders apply them to the picture.

const DOT = (row, c) => row.reduce((sum, value, k) => sum + value * c[k], 0);
const RRT = [[0.59719, 0.35458, 0.04823], [0.07600, 0.90834, 0.01566], [0.02840, 0.13383, 0.83777]];
const ODT = [[1.60475, -0.53108, -0.07367], [-0.10208, 1.10813, -0.00605], [-0.00327, -0.07276, 1.07602]];

/** Linear light of the screen of linear radiance; rna_render/image/view_transform.py names the source. */
export function filmic(rgb) {
  const curved = RRT.map((row) => {
    const x = 1.461926 * DOT(row, rgb);
    return (x * (x + 0.0245786) - 0.000090537) / (x * (0.983729 * x + 0.432951) + 0.238081);
  });
  return ODT.map((row) => DOT(row, curved));
}

/** The radiance that filmic shows as this dark grey: by steps that come nearer. */
export function beforeFilmic(shown) {
  let rgb = [...shown];
  for (let step = 0; step < 60; step++) {
    const result = filmic(rgb);
    rgb = rgb.map((value, c) => value * Math.min(2, Math.max(0.5, shown[c] / Math.max(result[c], 1e-6))));
  }
  return rgb;
}

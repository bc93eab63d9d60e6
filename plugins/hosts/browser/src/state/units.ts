// Units of length by their UCUM codes, as in files and in the driver.
import type { State } from './state';

/** The units that a user can choose. */
export const units = ['um', 'mm', 'cm', 'm', '[in_i]'];

const names: Record<string, string> = { um: 'µm', '[in_i]': 'inch', '[ft_i]': 'ft' };

export function unitName(code: string): string {
  return names[code] ?? code;
}

/** The name of the unit of the open mesh; empty: unknown. */
export function unitOf({ mesh }: State): string {
  return mesh ? unitName(mesh.unit || mesh.info.unit) : '';
}

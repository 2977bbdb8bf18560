export const loadPalette = () => import('../palette/CommandPalette').then(({ CommandPalette }) => CommandPalette)
export const loadKeysSheet = () => import('./KeysSheet').then(({ KeysSheet }) => KeysSheet)

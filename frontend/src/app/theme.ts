import {
  type CSSVariablesResolver,
  createTheme,
  localStorageColorSchemeManager,
  type MantineColorsTuple,
} from '@mantine/core'

const INK: MantineColorsTuple = [
  '#f7f7f5',
  '#ecedea',
  '#dadcd6',
  '#b4b7b0',
  '#979c96',
  '#82867f',
  '#5c605a',
  '#41453f',
  '#22262a',
  '#131514',
]

export const theme = createTheme({
  primaryColor: 'ink',
  primaryShade: { light: 9, dark: 0 },
  colors: { ink: INK },
  fontFamily: 'var(--sl-font)',
  fontFamilyMonospace: 'var(--sl-mono)',
  headings: {
    fontFamily: 'var(--sl-font)',
    fontWeight: '500',
    sizes: {
      h1: { fontSize: 'var(--sl-fs-head)', lineHeight: 'var(--sl-lh-head)' },
      h2: { fontSize: 'var(--sl-fs-title)', lineHeight: 'var(--sl-lh-title)' },
      h3: { fontSize: 'var(--sl-fs-lead)', lineHeight: 'var(--sl-lh-lead)' },
    },
  },
  fontSizes: { xs: '11px', sm: '12px', md: '13px', lg: '15px', xl: '18px' },
  lineHeights: { xs: '16px', sm: '16px', md: '20px', lg: '22px', xl: '24px' },
  spacing: { xs: '4px', sm: '8px', md: '12px', lg: '16px', xl: '24px' },
  radius: { xs: '3px', sm: '5px', md: '8px' },
  defaultRadius: 'sm',
  shadows: {
    xs: 'none',
    sm: 'none',
    md: 'var(--sl-shadow-pop)',
    lg: 'var(--sl-shadow-pop)',
    xl: 'var(--sl-shadow-pop)',
  },
  respectReducedMotion: true,
  focusRing: 'auto',
  cursorType: 'pointer',
  autoContrast: false,
  components: Object.fromEntries(
    [
      'TextInput',
      'PasswordInput',
      'NumberInput',
      'Select',
      'MultiSelect',
      'Autocomplete',
      'TagsInput',
      'Textarea',
      'FileInput',
      'Checkbox',
      'Radio',
      'Switch',
    ].map((name) => [name, { defaultProps: { size: 'xs' } }]),
  ),
})

const TOKENS = {
  '--mantine-color-body': 'var(--sl-bg)',
  '--mantine-color-text': 'var(--sl-ink)',
  '--mantine-color-dimmed': 'var(--sl-ink-3)',
  '--mantine-color-placeholder': 'var(--sl-ink-3)',
  '--mantine-color-default': 'var(--sl-raised)',
  '--mantine-color-default-hover': 'var(--sl-hover)',
  '--mantine-color-default-border': 'var(--sl-edge)',
  '--mantine-color-default-color': 'var(--sl-ink)',
  '--mantine-primary-color-filled': 'var(--sl-ink)',
  '--mantine-primary-color-filled-hover': 'var(--sl-ink-2)',
  '--mantine-primary-color-contrast': 'var(--sl-on-ink)',
  '--mantine-primary-color-light': 'var(--sl-select)',
  '--mantine-primary-color-light-hover': 'var(--sl-hover)',
  '--mantine-primary-color-light-color': 'var(--sl-ink)',
  '--mantine-color-ink-filled': 'var(--sl-ink)',
  '--mantine-color-ink-filled-hover': 'var(--sl-ink-2)',
  '--mantine-color-ink-light': 'var(--sl-select)',
  '--mantine-color-ink-light-hover': 'var(--sl-hover)',
  '--mantine-color-ink-light-color': 'var(--sl-ink)',
  '--mantine-color-error': 'var(--sl-bad)',
  '--mantine-color-success': 'var(--sl-ok)',
  '--mantine-color-anchor': 'var(--sl-ink)',
  '--mantine-color-bright': 'var(--sl-ink)',
  '--mantine-color-disabled': 'transparent',
  '--mantine-color-disabled-color': 'var(--sl-ink-3)',
  '--mantine-color-disabled-border': 'var(--sl-line)',
}

/** Points Mantine's own variables at our tokens, in both schemes. */
export const tokensForMantine: CSSVariablesResolver = () => ({
  variables: { '--mantine-line-height': 'var(--sl-lh-body)', '--input-height-xs': '28px' },
  light: TOKENS,
  dark: TOKENS,
})

/** Keeps light, dark or auto in the browser; public/scheme.js reads it before the first paint. */
export const schemeManager = localStorageColorSchemeManager({ key: 'soundlist-scheme' })

import { readdirSync, readFileSync } from 'node:fs'
import { join } from 'node:path'

import { describe, expect, test } from 'vitest'

/** WCAG 2.2, success criteria 1.4.3 and 1.4.11. */
const LEAST = { text: 4.5, shape: 3 }

const NEUTRALS = ['bg', 'surface', 'raised', 'well', 'hover', 'select', 'key']
const INKS = ['ink', 'ink-2', 'ink-3']
const TONES = ['ok', 'bad', 'warn', 'change', 'review', 'idle']
/** Icons and bars; those on a hovered row or on a tint stand beside a word that says the same. */
const SHAPES = ['edge', 'now', 'focus', ...TONES.map((tone) => `${tone}-solid`)]
const BEHIND_SHAPES = ['bg', 'surface', 'raised', 'well']

type Tokens = Record<string, string>

function tokensOf(css: string): Record<'light' | 'dark', Tokens> {
  const [light = '', dark = ''] = css.split(":root[data-mantine-color-scheme='dark']")
  const read = (block: string): Tokens =>
    Object.fromEntries(
      Array.from(block.matchAll(/--sl-([\w-]+): (#[0-9a-f]{6});/g), ([, name = '', value = '']): [string, string] => [
        name,
        value,
      ]),
    )
  return { light: read(light), dark: { ...read(light), ...read(dark) } }
}

/** The relative luminance of an sRGB colour, as WCAG defines it: from 0, black, to 1, white. */
function luminance(hex: string): number {
  const [red = 0, green = 0, blue = 0] = [1, 3, 5].map((at) => {
    const value = parseInt(hex.slice(at, at + 2), 16) / 255
    return value <= 0.04045 ? value / 12.92 : ((value + 0.055) / 1.055) ** 2.4
  })
  return 0.2126 * red + 0.7152 * green + 0.0722 * blue
}

function contrast(one: string, other: string): number {
  const [darker = 0, lighter = 0] = [luminance(one), luminance(other)].sort((a, b) => a - b)
  return (lighter + 0.05) / (darker + 0.05)
}

/** The colours of the words of each rule of our sheets, and what the same rule puts behind them. */
function rules(): { where: string; color: string; background: string | null }[] {
  const sheets = readdirSync('src', { recursive: true, encoding: 'utf8' }).filter((path) => path.endsWith('.css'))
  return sheets.flatMap((path) => {
    const css = readFileSync(join('src', path), 'utf8').replace(/\/\*.*?\*\//gs, '')
    return [...css.matchAll(/([^{}]+)\{([^{}]*)\}/g)].flatMap(([, selector = '', body = '']) => {
      const token = (property: string) =>
        new RegExp(`(?:^|[;\\s])${property}:\\s*var\\(--(?:sl-)?([\\w-]+)\\)`).exec(body)?.[1] ?? null
      const color = token('color')
      return color ? [{ where: `${path}: ${selector.trim()}`, color, background: token('background') }] : []
    })
  })
}

const RULES = rules()

const inTones = (token: string) =>
  token.startsWith('tone') ? TONES.map((tone) => token.replace('tone', tone)) : [token]

test('contrast is that of WCAG', () => {
  expect(contrast('#000000', '#ffffff')).toBeCloseTo(21, 6)
  expect(contrast('#777777', '#ffffff')).toBeCloseTo(4.48, 2) // the nearest grey that fails
  expect(contrast('#767676', '#ffffff')).toBeCloseTo(4.54, 2)
})

test('each colour of words in the sheets is one of those that are compared here', () => {
  const compared = [...INKS, 'on-ink', ...TONES, ...SHAPES]
  expect(RULES.length).toBeGreaterThan(100)
  const others = RULES.filter(({ color }) => inTones(color).some((token) => !compared.includes(token)))
  expect(others.map(({ where, color }) => `${where}: ${color}`)).toEqual([])
})

describe.each(Object.entries(tokensOf(readFileSync('src/app/tokens.css', 'utf8'))))('%s', (_, tokens) => {
  const ratioOf = (color: string, background: string): number => {
    const [one, other] = [tokens[color], tokens[background]]
    if (!one || !other) throw new Error(`no token ${one ? background : color}`)
    return contrast(one, other)
  }
  const tooClose = (pairs: readonly (readonly [string, string])[], least: number): string[] =>
    pairs
      .filter((pair) => ratioOf(...pair) < least)
      .map((pair) => `${pair.join(' on ')}: ${ratioOf(...pair).toFixed(2)}, ${least} needed`)
  const each = (colors: string[], backgrounds: string[]) =>
    colors.flatMap((color) => backgrounds.map((background) => [color, background] as const))

  test('words are readable on every surface, tint and filled button', () => {
    const onTints = TONES.flatMap((tone) => each([tone, ...INKS], [`${tone}-tint`]))
    const pairs = [...each([...INKS, ...TONES], NEUTRALS), ...onTints, ['on-ink', 'ink'] as const]
    expect(tooClose(pairs, LEAST.text)).toEqual([])
  })

  test('icons, edges and the focus ring stand out from what is behind them', () => {
    expect(tooClose(each(SHAPES, BEHIND_SHAPES), LEAST.shape)).toEqual([])
  })

  test('words are readable where a rule names what is behind them', () => {
    const pairs = RULES.flatMap(({ color, background }) => {
      if (background === null || color.endsWith('-solid') || SHAPES.includes(color)) return []
      return color.startsWith('tone') && background.startsWith('tone')
        ? TONES.map((tone) => [color.replace('tone', tone), background.replace('tone', tone)] as const)
        : inTones(color).flatMap((one) => inTones(background).map((other) => [one, other] as const))
    })
    expect(pairs.length).toBeGreaterThan(50)
    expect(tooClose(pairs, LEAST.text)).toEqual([])
  })
})

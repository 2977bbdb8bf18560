import { existsSync, readdirSync, readFileSync } from 'node:fs'
import { dirname, join, normalize } from 'node:path'

import { expect, test } from 'vitest'

const SOURCES = readdirSync('src', { recursive: true, encoding: 'utf8' })
  .filter((path) => /\.tsx?$/.test(path) && !path.endsWith('.test.tsx'))
  .map((path) => join('src', path))

const STYLED = SOURCES.flatMap((path) => {
  const text = readFileSync(path, 'utf8')
  return [...text.matchAll(/import (\w+) from '([^']+\.module\.css)'/g)].map(([, name = '', sheet = '']) => ({
    path,
    sheet: normalize(sheet.startsWith('@/') ? sheet.replace('@', 'src') : join(dirname(path), sheet)),
    used: [...text.matchAll(new RegExp(`\\b${name}\\.(\\w+)`, 'g'))].map(([, used = '']) => used),
    isAskedByName: text.includes(`${name}[`),
  }))
})

/** The classes that a sheet makes for its own parts; what is global it only meets. */
function classesOf(sheet: string): Set<string> {
  const own = readFileSync(sheet, 'utf8')
    .replace(/\/\*.*?\*\//gs, '')
    .replace(/:global\([^)]*\)/g, '')
  const selectors = [...own.matchAll(/([^{}]+)\{/g)].map(([, selector = '']) => selector)
  return new Set(selectors.flatMap((one) => [...one.matchAll(/\.([A-Za-z_]\w*)/g)].map(([, name = '']) => name)))
}

test('every class that a part asks for is in its sheet', () => {
  const missing = STYLED.flatMap(({ path, sheet, used }) => {
    const there = classesOf(sheet)
    return used.filter((name) => !there.has(name)).map((name) => `${path}: ${name} is not in ${sheet}`)
  })
  expect(STYLED.length).toBeGreaterThan(50)
  expect(missing).toEqual([])
})

test('every class of a sheet is asked for', () => {
  const asked = new Map<string, Set<string>>()
  for (const { sheet, used } of STYLED) asked.set(sheet, new Set([...(asked.get(sheet) ?? []), ...used]))
  for (const { sheet, isAskedByName } of STYLED) if (isAskedByName) asked.delete(sheet)
  const idle = [...asked].flatMap(([sheet, used]) =>
    [...classesOf(sheet)].filter((name) => !used.has(name)).map((name) => `${sheet}: nobody asks for ${name}`),
  )
  expect(idle).toEqual([])
})

const MANTINE = 'node_modules/@mantine/core'

/** The modules of Mantine that one of them needs, itself included. */
function neededBy(module: string, found = new Set<string>()): Set<string> {
  if (found.has(module) || !existsSync(module)) return found
  found.add(module)
  for (const [, path = ''] of readFileSync(module, 'utf8').matchAll(/from\s*"(\.[^"]+)"/g)) {
    neededBy(join(dirname(module), path), found)
  }
  return found
}

test('the sheet of every Mantine component in use is loaded', () => {
  const used = SOURCES.flatMap((path) =>
    [...readFileSync(path, 'utf8').matchAll(/import \{([^}]*)\} from '@mantine\/core'/g)].flatMap(([, names = '']) =>
      [...names.matchAll(/\b[A-Z]\w+/g)].map(([name]) => name),
    ),
  )
  const modules = used.flatMap((name) => [...neededBy(`${MANTINE}/esm/components/${name}/${name}.mjs`)])
  const sheets = new Set(modules.flatMap((path) => /(\w+)\.module\.mjs$/.exec(path)?.[1] ?? []))
  const loaded = readFileSync('src/app/mantineStyles.ts', 'utf8')
  expect([...sheets]).toContain('Input')
  expect([...sheets].filter((name) => !loaded.includes(`/${name}.layer.css`))).toEqual([])
})

import { describe, expect, test } from 'vitest'

import { bytes, File } from '@/test/upload'

import { filesOfDrop, filesOfField, isClutter } from './drops'

describe('drops', () => {
  const wav = (name: string) => new File([bytes('RIFF....WAVE')], name)
  const fileEntry = (path: string) => ({
    isFile: true,
    isDirectory: false,
    fullPath: path,
    file: (give: (file: File) => void) => give(wav(path.split('/').at(-1) ?? '')),
  })
  const folder = (path: string, inside: object[]) => ({
    isFile: false,
    isDirectory: true,
    fullPath: path,
    createReader: () => {
      const left = [...inside]
      return { readEntries: (give: (some: object[]) => void) => give(left.splice(0, 100)) }
    },
  })
  const drop = (entries: (object | null)[], files: File[] = []) =>
    ({
      items: entries.map((entry, index) => ({ webkitGetAsEntry: () => entry, getAsFile: () => files[index] ?? null })),
      files,
    }) as unknown as DataTransfer

  test('folders are walked to the end, a hundred at a time, without what systems leave about', async () => {
    const many = Array.from({ length: 250 }, (_, index) => fileEntry(`/sfx/steps/step_${index}.wav`))
    const picked = await filesOfDrop(
      drop(
        [folder('/sfx', [fileEntry('/sfx/.DS_Store'), folder('/sfx/steps', many)]), fileEntry('/laser.wav')],
        [wav('sfx'), wav('laser.wav')],
      ),
    )
    expect(picked).toHaveLength(251)
    expect(picked[0]?.path).toBe('sfx/steps/step_0.wav')
    expect(picked.at(-1)?.path).toBe('laser.wav')
  })

  test('a file is taken as it comes: asking a thousand entries for theirs takes long', async () => {
    const file = () => {
      throw new Error('asked of its entry')
    }
    const picked = await filesOfDrop(drop([{ ...fileEntry('/laser.wav'), file }], [wav('laser.wav')]))
    expect(picked.map(({ path }) => path)).toEqual(['laser.wav'])
  })

  test('without entries the plain list counts', async () => {
    const picked = await filesOfDrop(drop([null], [wav('laser.wav')]))
    expect(picked.map(({ path }) => path)).toEqual(['laser.wav'])
  })

  test('a folder field keeps the folders', () => {
    const file = wav('a.wav')
    Object.defineProperty(file, 'webkitRelativePath', { value: 'sfx/a.wav' })
    expect(filesOfField([file, wav('.hidden.wav')]).map(({ path }) => path)).toEqual(['sfx/a.wav'])
  })

  test.each(['.DS_Store', 'sfx/__MACOSX/a.wav', 'sfx/Thumbs.db', 'sfx/.git/config'])('%s is clutter', (path) => {
    expect(isClutter(path)).toBe(true)
  })
})

import { File as NodeFile } from 'node:buffer'

import { QueryClient } from '@tanstack/react-query'
import { beforeEach, expect, test } from 'vitest'

import { forgetDrafts, openDraftsOf } from '@/app/drafts'
import type { Accepts, Picked } from '@/uploads'

import { DeliveryUploads } from './deliveryUploads'
import { refusedNameOf, refusedRows } from './rows'

const ANY_WAV: Accepts = { kinds: ['wav'], sampleRatesHz: null, bitDepths: null }
const MP3 = new Uint8Array([0x49, 0x44, 0x33, 4, 0, 0, 0, 0, 0, 0])
const picked = (path: string): Picked => ({
  path,
  file: new NodeFile([MP3], path.split('/').at(-1)!) as unknown as File,
})
/** The desk of a person as a page that was just opened has it. */
const opened = () => new DeliveryUploads(new QueryClient(), 'p1', ANY_WAV)

beforeEach(() => {
  forgetDrafts()
  openDraftsOf('x3')
})

test('what was refused is on the desk after a reload, with its reason, until it is removed', async () => {
  await opened().queue.add([picked('boss/sting.mp3'), picked('laser.mp3')])
  const desk = opened()
  const [sting, laser] = refusedRows(desk.refused.get())
  expect(sting).toMatchObject({ name: 'boss/sting.mp3', state: 'not_sent', does: 'dismiss' })
  expect(sting?.detail).toMatch(/This is an MP3.*drop the file again\.$/)
  desk.forgetRefused(refusedNameOf(laser!.id)!)
  expect(
    opened()
      .refused.get()
      .map(({ name }) => name),
  ).toEqual(['boss/sting.mp3'])
})

test('what is dropped again is listed once, as what it is now', async () => {
  await opened().queue.add([picked('sting.mp3'), picked('laser.mp3')])
  const desk = opened()
  await desk.queue.add([picked('sting.mp3')])
  expect(desk.refused.get().map(({ name }) => name)).toEqual(['laser.mp3'])
  expect(opened().refused.get()).toHaveLength(2)
})

test('who signs out leaves nothing behind for the next person', async () => {
  await opened().queue.add([picked('sting.mp3')])
  forgetDrafts()
  openDraftsOf('x4')
  expect(opened().refused.get()).toEqual([])
})
